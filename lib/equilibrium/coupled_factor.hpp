// SPDX-License-Identifier: BSD-3-Clause
// A sparse factor of the tangent, and a Krylov solver (GMRES, Saad and Schultz 1986) that uses an older factor as
// preconditioner: from iteration to iteration the tangent changes in few places, so a few products replace a new factor.
#pragma once

#include <vector>

#include "equilibrium/coupled_system.hpp"
#include "equilibrium/multifrontal.hpp"

namespace hfrac {

class CoupledFactor {
 public:
  using Vector = CoupledSystem::Vector;

  // Of the tangent at the last evaluation.
  void compute(const CoupledSystem& system);
  [[nodiscard]] bool ready() const { return ready_; }
  void forget() { ready_ = false; }
  // Other pairs of discs are near: the pattern is found anew with the next factor.
  void forget_pattern() { entries_ = 0; }
  [[nodiscard]] Vector solve(const Vector& right);

 private:
  Multifrontal factor_;
  std::vector<double> values_;
  std::size_t entries_ = 0;  // of the pattern analysed
  bool ready_ = false;
};

struct KrylovOutcome {
  int iterations = 0;
  bool converged = false;
};
// Solves tangent x = right to |tangent x - right| <= tolerance |right|, from x = 0.
KrylovOutcome solve_preconditioned(const CoupledSystem& system, CoupledFactor& factor,
                                   const CoupledSystem::Vector& right, double tolerance, int most,
                                   CoupledSystem::Vector& x);

}  // namespace hfrac
