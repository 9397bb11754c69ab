// SPDX-License-Identifier: BSD-3-Clause
#include "linear/conjugate_gradient.hpp"

#include <algorithm>
#include <cmath>

#include "core/give_back.hpp"
#include "linear/device_conjugate_gradient.hpp"
#include "linear/serial_block.hpp"

namespace hfrac {

void symmetric_product(const SparseMatrix& lower, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  const auto n = lower.cols();
  const int* start = lower.outerIndexPtr();
  const int* row = lower.innerIndexPtr();
  const double* value = lower.valuePtr();
  y.setZero(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double here = x[k];
    double sum = value[start[k]] * here;
    for (int a = start[k] + 1; a < start[k + 1]; ++a) {
      sum += value[a] * x[row[a]];
      y[row[a]] += value[a] * here;
    }
    y[k] += sum;
  }
}

ConjugateGradient::ConjugateGradient(Workers* workers, const Device* device, const Ranks& ranks)
    : team_(workers != nullptr ? *workers : alone_, ranks),
      has_workers_(workers != nullptr),
      multigrid_(device != nullptr ? Ranks{} : ranks, workers) {
  if (device != nullptr) on_device_ = std::make_unique<DeviceConjugateGradient>(*device);
}

ConjugateGradient::~ConjugateGradient() = default;

template <class Task>
void ConjugateGradient::share(const Task& task) {
  team_.share(has_workers_ && multigrid_.rows() >= rows_worth_sharing, multigrid_.is_over_ranks(), task);
}

// Each rank all rows.
template <class Task>
void ConjugateGradient::share_rows(const Task& task) {
  share_items(
      has_workers_ ? &team_.workers() : nullptr, multigrid_.rows(),
      [&](std::int64_t first, std::int64_t last) {
        task(static_cast<std::size_t>(first), static_cast<std::size_t>(last));
      },
      rows_worth_sharing, row_group);
}

// Vectors from the order of the matrix's rows to that of the finest level, and back.
void ConjugateGradient::take(const Eigen::VectorXd& rhs, const Eigen::VectorXd& x) {
  const auto& order = multigrid_.level(0).order;
  const auto rows = order.size();
  for (auto* per_row : {&b_, &x_, &r_, &d_, &p_, &z_}) per_row->resize(rows);  // what is in them comes later
  for (auto* per_group : {&sums_, &others_, &highest_, &lowest_})
    per_group->resize(static_cast<std::size_t>(multigrid_.groups()));
  share_rows([&](std::size_t first, std::size_t last) {
    for (auto i = first; i < last; ++i) {
      b_[i] = rhs[order[i]];
      x_[i] = x[order[i]];
    }
  });
  arrays_ = {multigrid_.groups(), b_.data(),    x_.data(),      r_.data(),       d_.data(),      p_.data(),
             z_.data(),           sums_.data(), others_.data(), highest_.data(), lowest_.data(), nullptr};
}

void ConjugateGradient::give(Eigen::VectorXd& x) {
  share([&](const RankTeam::Member& member) { member.gather(x_.data(), multigrid_.rows(), row_group); });
  const auto& order = multigrid_.level(0).order;
  share_rows([&](std::size_t first, std::size_t last) {
    for (auto i = first; i < last; ++i) x[order[i]] = x_[i];
  });
  // What makes the levels of the next matrix takes their place.
  for (auto* per_row : {&b_, &x_, &r_, &d_, &p_, &z_}) give_back(*per_row);
}

void ConjugateGradient::begin() {
  const LevelArrays& level = multigrid_.arrays()[0];
  share([&](const RankTeam::Member& member) {
    SerialBlock block;
    member.exchange(multigrid_.halo(), arrays_.x);
    Multigrid::each_group(member, level.rows, [&](std::int64_t g) { begin_pass(block, arrays_, level, g); });
    member.gather(arrays_.sums, arrays_.groups, 1);
  });
}

// x + d, and all ranks know how far values went.
void ConjugateGradient::end() {
  const LevelArrays& level = multigrid_.arrays()[0];
  share([&](const RankTeam::Member& member) {
    SerialBlock block;
    Multigrid::each_group(member, level.rows, [&](std::int64_t g) { end_pass(block, arrays_, level, g); });
    for (double* per_group : {arrays_.sums, arrays_.highest, arrays_.lowest})
      member.gather(per_group, arrays_.groups, 1);
  });
}

int ConjugateGradient::solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x, double tolerance, int most) {
  take(rhs, x);
  const LevelArrays& level = multigrid_.arrays()[0];
  SerialBlock block;
  for (std::int64_t g = 0; g < arrays_.groups; ++g)
    keep_sum(block, arrays_.sums, g, squared_length(block, level, arrays_.b, g));
  const double target = tolerance * std::sqrt(total_of_groups(block, arrays_.sums, arrays_.groups));
  begin();
  double length = 0.0;
  const int iterations = iterate(target, most, length);
  end();
  give(x);
  return iterations;
}

// Of d, until what is left of r is no longer than `target`: then of this length.
int ConjugateGradient::iterate(double target, int most, double& length) {
  const LevelArrays& level = multigrid_.arrays()[0];
  const ConjugateArrays& c = arrays_;
  double product = 1.0, far = 0.0;
  SerialBlock mine;
  for (int iteration = 0; iteration <= most; ++iteration) {
    length = std::sqrt(total_of_groups(mine, c.sums, c.groups));
    if (length <= target) return iteration;
    share([&](const RankTeam::Member& member) {
      SerialBlock block;
      const auto each = [&](const auto& visit) { Multigrid::each_group(member, level.rows, visit); };
      multigrid_.precondition(member, c.r, c.z);
      each([&](std::int64_t g) { multiply_residuals(block, c, level, g); });
      member.gather(c.sums, c.groups, 1);
      const double along = total_of_groups(block, c.sums, c.groups), kept = along / product;
      each([&](std::int64_t g) { turn_direction(block, c, level, kept, g); });
      member.exchange(multigrid_.halo(), c.p);
      each([&](std::int64_t g) { multiply_direction(block, c, level, g); });
      member.gather(c.others, c.groups, 1);
      const double step = along / total_of_groups(block, c.others, c.groups);
      each([&](std::int64_t g) { go_along(block, c, level, step, g); });
      if (member.is_first()) {  // the others have read the product before two barriers
        product = along;
        far = step;
      }
      member.gather(c.sums, c.groups, 1);
    });
    if (!std::isfinite(far)) return -1;
  }
  return -1;
}

bool ConjugateGradient::settle(const Eigen::VectorXd& rhs, Eigen::VectorXd& x, const PassRules& rules,
                               double& change) {
  take(rhs, x);
  const bool settled =
      on_device_ ? on_device_->settle(multigrid_, b_, x_, rules, change) : settle_here(rules, change);
  give(x);
  return settled;
}

bool ConjugateGradient::settle_here(const PassRules& rules, double& before) {
  SerialBlock mine;
  const ErrorBound& bound = multigrid_.error_bound();
  // Of the pass before, with before > 0.
  const auto lowest = [this] { return *std::min_element(lowest_.begin(), lowest_.end()); };
  const auto highest = [this] { return *std::max_element(highest_.begin(), highest_.end()); };
  for (int pass = 0; pass < rules.most_passes; ++pass) {
    begin();
    double length = std::sqrt(total_of_groups(mine, arrays_.sums, arrays_.groups));
    if (!(length > 0.0)) return true;
    const double least = before > 0.0 ? rules.least_target(bound, lowest(), highest()) : 0.0;
    if (iterate(std::max(rules.pass_tolerance * length, least), rules.most_iterations, length) < 0)
      return false;
    end();
    const double change = *std::max_element(sums_.begin(), sums_.end());
    const bool there = rules.are_there(bound, length, lowest(), highest()) ||
                       rules.are_there(change, before, lowest(), highest());
    before = change;
    if (there) return true;
  }
  return false;
}

}  // namespace hfrac
