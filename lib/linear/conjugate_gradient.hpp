// SPDX-License-Identifier: BSD-3-Clause
// Conjugate gradients, preconditioned by multigrid, for the flow matrix of models too large to factorise.
//
// Ranks and their workers share the vectors by groups of rows of fixed length, or a card of each rank does all of it
// (device_conjugate_gradient.hpp); a sum over a group is made in one way, and so is the sum over groups, which all ranks know
// (conjugate_kernels.hpp). So the bits depend neither on who does it nor on how many do.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <vector>

#include "core/rank_team.hpp"
#include "linear/multigrid.hpp"
#include "linear/sparse.hpp"

namespace hfrac {

class Device;
class DeviceConjugateGradient;

// y = A x of a symmetric matrix by its lower triangle, each column beginning with its diagonal.
void symmetric_product(const SparseMatrix& lower, const Eigen::VectorXd& x, Eigen::VectorXd& y);

// When a solution in passes is good enough: each solves for what is left to `pass_tolerance` of it, until the matrix bounds the error
// (ErrorBound) by `settled` times the largest difference of values, or no value changes by more than that. Where all values are nearly alike that is less than their rounding: once a pass no
// longer halves the change, `settled` times the largest value will do.
struct PassRules {
  double pass_tolerance, settled;
  int most_passes, most_iterations;  // passes; iterations of a pass
  // Whether values between `lowest` and `highest` that changed by `change`, and in the pass before by `before` (0: there was none), are there.
  // The next pass would change them less, by as much as this one did.
  [[nodiscard]] bool are_there(double change, double before, double lowest, double highest) const {
    const bool halved = !(before > 0.0) || change <= 0.5 * before;
    const double next = before > 0.0 ? change * std::min(1.0, change / before) : change;
    return next <= settled * (halved ? highest - lowest : std::max({highest - lowest, highest, -lowest}));
  }
  // The same of values whose residual is so long.
  [[nodiscard]] bool are_there(const ErrorBound& bound, double length, double lowest, double highest) const {
    return bound.at(length, std::max(highest, -lowest)) <= settled * (highest - lowest);
  }
  // Length of a residual below which a pass need not go, where the values after the last one are known; half of what would do.
  [[nodiscard]] double least_target(const ErrorBound& bound, double lowest, double highest) const {
    return 0.5 * bound.length_for(settled * (highest - lowest));
  }
};

class ConjugateGradient {
 public:
  // Without workers on the calling thread alone. Of several ranks, all do the same; with a device, `settle` is its, on each rank.
  explicit ConjugateGradient(Workers* workers = nullptr, const Device* device = nullptr,
                             const Ranks& ranks = {});
  ~ConjugateGradient();
  ConjugateGradient(const ConjugateGradient&) = delete;
  ConjugateGradient& operator=(const ConjugateGradient&) = delete;

  // `lower` is the lower triangle of a symmetric positive definite matrix, each column beginning with its diagonal. False if an entry of
  // the diagonal is not positive or not finite.
  [[nodiscard]] bool prepare(const SparseMatrix& lower) { return multigrid_.prepare(lower); }
  // Of all rows.
  using Pattern = Multigrid::Pattern;
  [[nodiscard]] bool prepare(const SymmetricRows& rows, Pattern pattern) {
    return multigrid_.prepare(rows, pattern);
  }

  // Improves x until the residual, scaled by the diagonal, is below `tolerance` of the right-hand side's. Returns the iterations it
  // took, or -1 if `most` were not enough.
  int solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x, double tolerance, int most);
  // Improves x in passes; false if the rules' numbers of them were not enough. change: by how much values changed in the last pass, 0
  // before the first, of this matrix.
  [[nodiscard]] bool settle(const Eigen::VectorXd& rhs, Eigen::VectorXd& x, const PassRules& rules,
                            double& change);
  [[nodiscard]] bool settle(const Eigen::VectorXd& rhs, Eigen::VectorXd& x, const PassRules& rules) {
    double change = 0.0;
    return settle(rhs, x, rules, change);
  }

 private:
  void take(const Eigen::VectorXd& rhs, const Eigen::VectorXd& x);
  void give(Eigen::VectorXd& x);
  void begin();
  void end();
  int iterate(double target, int most, double& length);
  bool settle_here(const PassRules& rules, double& before);
  template <class Task>
  void share(const Task& task);
  template <class Task>
  void share_rows(const Task& task);

  Workers alone_{1};
  RankTeam team_;
  bool has_workers_;
  Multigrid multigrid_;
  std::unique_ptr<DeviceConjugateGradient> on_device_;
  // In the order of the finest level's rows, and of its groups.
  UnfilledVector b_, x_, r_, d_, p_, z_;
  std::vector<double> sums_, others_, highest_, lowest_;
  ConjugateArrays arrays_{};
};

}  // namespace hfrac
