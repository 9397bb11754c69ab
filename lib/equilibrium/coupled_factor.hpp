// SPDX-License-Identifier: BSD-3-Clause
// A sparse factor L D L' of the tangent, and a Krylov solver (GMRES, Saad and Schultz 1986) that uses an older factor as
// preconditioner: from step to step the tangent changes in few places, so a few iterations replace a new factor.
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "equilibrium/coupled_system.hpp"

namespace hfrac {

class CoupledFactor {
 public:
  using Vector = CoupledSystem::Vector;

  // Of the tangent at the last evaluation. Throws Error(diverged) if it cannot be had.
  void compute(const CoupledSystem& system);
  [[nodiscard]] bool ready() const { return ready_; }
  void forget() { ready_ = false; }
  // The order of elimination is found anew with the next factor.
  void forget_order() { order_.clear(); }
  [[nodiscard]] Vector solve(const Vector& right) const;
  [[nodiscard]] double entries() const { return entries_; }

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  std::vector<Eigen::Index> order_, place_;  // unknown at each place, and place of each unknown
  std::vector<Eigen::Triplet<double>> list_;
  Matrix matrix_;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
  double entries_ = 0.0;
  bool ready_ = false;
};

struct KrylovOutcome {
  int iterations = 0;
  bool converged = false;
};
// Solves tangent x = right to |tangent x - right| <= tolerance |right|, from x = 0.
KrylovOutcome solve_preconditioned(const CoupledSystem& system, const CoupledFactor& factor,
                                   const CoupledSystem::Vector& right, double tolerance, int most,
                                   CoupledSystem::Vector& x);

}  // namespace hfrac
