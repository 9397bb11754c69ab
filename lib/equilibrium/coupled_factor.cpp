// SPDX-License-Identifier: BSD-3-Clause
#include "equilibrium/coupled_factor.hpp"

#include "core/give_back.hpp"

namespace hfrac {

namespace {

constexpr double most_single = 1e5;  // entry, of bonds' about 1, up to which single precision does

}  // namespace

void CoupledFactor::compute(const CoupledSystem& system) {
  ready_ = false;  // until all of it is there: memory may run out on the way
  if (outside_) return compute_outside(system);
  system.entries(values_, 0, system.size());
  if (values_.size() != entries_) {
    entries_ = 0;
    const auto s = system.structure();
    tree_.analyse(s.node_start, s.position, s.graph, s.late, s.places);
    entries_ = values_.size();
  }
  const double largest =
      Eigen::Map<const Eigen::ArrayXd>(values_.data(), static_cast<Eigen::Index>(values_.size()))
          .abs()
          .maxCoeff();
  doubled_ = exact_ || !(largest < most_single);
  if (doubled_) {
    coarse_.clear();
    fine_.factorise(tree_, values_, workers_);
  } else {
    fine_.clear();
    coarse_.factorise(tree_, values_, workers_);
  }
  give_back(values_);
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
    fine_.solve(tree_, x.data(), workers_);
  else
    coarse_.solve(tree_, x.data(), workers_);
}

}  // namespace hfrac
