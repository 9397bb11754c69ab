// SPDX-License-Identifier: BSD-3-Clause
// Equilibrium found directly: Newton's method on the coupled equations, bonds broken in order.
//
// A solve goes in rounds. Each finds equilibrium of the rock as it is (coupled_system.hpp), then looks for bonds beyond their
// strength: the farthest beyond breaks, with others far enough away not to feel it, and the next round begins. The solve
// ends when nothing breaks any more. Between rounds sliding contacts keep what they slid.
//
// Tangents are kept as factors for as long as they precondition well (coupled_factor.hpp). A solve that does not converge
// says so and leaves the state for the caller to put back.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "equilibrium/coupled_factor.hpp"
#include "equilibrium/coupled_system.hpp"
#include "frac/tip.hpp"
#include "linear/krylov.hpp"
#include "solid/explicit_solver.hpp"

namespace hfrac {

class EquilibriumSolver {
 public:
  EquilibriumSolver(Model& model, Facets& facets, Boundary& boundary, ExplicitSolver& mechanics,
                    const Options& options, Workers& workers);

  enum class End { rest, stopped, overshoot, not_converged };
  struct Outcome {
    End end = End::not_converged;
    int rounds = 0, newton = 0, krylov = 0, factors = 0;
    double force_ratio = 0.0;
    double excess = 0.0;       // largest stress over strength at the first equilibrium
    double last_excess = 0.0;  // and at the last one
    Vec2 where;                // m: the place farthest from equilibrium, if it was not found
  };
  // `duration` [s] of flow with source[d] [m2/s], 0 for undrained equilibrium. If bonds are to break and the first
  // equilibrium exceeds a strength by more than the factor `most_excess`, the solve ends there (overshoot).
  Outcome solve(double duration, const std::vector<double>& source, double most_excess, CrackLog& log,
                const std::function<bool()>& interrupt = {});

  // Model time at the end of the solves that follow [s], by which tips know their speed.
  void set_time(double time) { time_ = time; }

  // The undrained equilibrium of displacements and pressures, whatever the bonds bear; nothing breaks, and no forces are kept.
  bool rest_unbroken();

  // Looks for intact bonds beyond their strength. Returns the largest stress over strength of all.
  double find_exceeding();

  // A step begins: what it does follows from the state alone, so no factor outlives the step before. Without that, a run
  // gone on with after a restore would differ in the last digits.
  void begin_step();

 private:
  // Whether fluid flows by what fractures or joints are open.
  [[nodiscard]] bool fractured() const { return !facets_.all().empty() || !network_.joint_pore.empty(); }
  bool find_rest_of_fractures(Outcome& outcome, const std::function<bool()>& interrupt);
  bool find_rest(Outcome& outcome, const std::function<bool()>& interrupt);
  // How steps are cut where faces open and slide: by the work of the forces left, or where the residual goes in a circle.
  enum class Way { by_work, by_residual };
  bool find_rest(Outcome& outcome, const std::function<bool()>& interrupt, Way way);
  struct Exceeding {
    double excess;  // stress over strength, at least 1
    std::int64_t bond;
    bool at_tip = false;  // of a fracture that goes on: mode I, whatever the bond bears
  };
  void keep_round();
  void break_farthest(CrackLog& log);

  Assembly& assembly_;
  Network& network_;
  Boundary& boundary_;
  ExplicitSolver& mechanics_;
  const Options& options_;
  Facets& facets_;
  CoupledSystem system_;
  CoupledFactor factor_;
  Krylov krylov_;
  CoupledSystem::Vector gone_;  // since find_rest began
  std::vector<double> pressure_start_;
  std::vector<Exceeding> exceeding_;
  double time_ = 0.0;
  double krylov_rate_ = 0.0;  // iterations of the last linear solve per power of ten gained
  bool flowed_ = false;
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs_;  // that the order of elimination knows
};

}  // namespace hfrac
