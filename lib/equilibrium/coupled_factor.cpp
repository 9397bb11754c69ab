// SPDX-License-Identifier: BSD-3-Clause
#include "equilibrium/coupled_factor.hpp"

#include "core/array.hpp"
#include "core/give_back.hpp"

namespace hfrac {

namespace {

constexpr double most_single = 1e5;  // entry, of bonds' about 1, up to which single precision does

}  // namespace

void CoupledFactor::compute(const CoupledSystem& system) {
  ready_ = false;  // until all of it is there: memory may run out on the way
  if (outside_) return compute_outside(system);
  if (const std::size_t all = system.entry_count(); all != entries_) {
    entries_ = 0;
    {
      const auto s = system.structure();
      tree_.analyse(s.node_start, s.position, s.graph, s.late, s.each_place, ranks_.rank(), ranks_.size());
    }
    return_unused_pages();  // the factor wants the room
    entries_ = all;
  }
  doubled_ =
      exact_ || sharing().any(!(system.entries(single_, tree_.wanted, tree_.entry.size()) < most_single));
  if (doubled_) {
    give_back(single_);
    coarse_.clear();
    system.entries(values_, tree_.wanted, tree_.entry.size());
    fine_.factorise(tree_, values_, workers_, sharing());
    give_back(values_);
  } else {
    fine_.clear();
    coarse_.factorise(tree_, single_, workers_, sharing());
    give_back(single_);
  }
  ready_ = true;
}

void CoupledFactor::compute_outside(const CoupledSystem& system) {
  std::vector<std::int32_t> row, column;
  const auto rows = outside_->rows();
  std::size_t all = entries_ > 0 ? system.entries(values_, rows.first, rows.end) : 0;
  if (all == 0 || all != entries_) {
    outside_->share_out(system.entries_of_rows());
    const auto mine = outside_->rows();
    all = system.entries(values_, mine.first, mine.end);
    system.places(row, column, mine.first, mine.end);
  }
  entries_ = 0;
  outside_->prepare(row, column, values_);
  give_back(values_);  // the factor, made with the first solve, wants the room
  entries_ = all;
  doubled_ = ready_ = true;
}

bool CoupledFactor::refine() {
  exact_ = true;
  return !doubled_;
}

void CoupledFactor::solve(const Vector& right, Vector& x) {
  if (outside_) {
    x.resize(right.size());
    outside_->solve(right.data(), x.data(), 0.0);
    return;
  }
  x = right;
  if (doubled_)
    fine_.solve(tree_, x.data(), workers_, sharing());
  else
    coarse_.solve(tree_, x.data(), workers_, sharing());
}

}  // namespace hfrac
