// SPDX-License-Identifier: BSD-3-Clause
// One step of flow through the pipes while the rock stands still.
//
// Both schemes move content along pipes, so what one domain loses the next one gains to the last bit but rounding:
//   implicit  backward Euler on all domains at once (sparse Cholesky, the pattern analysed once; conjugate gradients for
//             more than some 60 000 domains, where factors outgrow memory, by all ranks together, and from 20 000 on in steps so short that
//             pores hardly depend on each other; or a solver from outside). Cavitation makes it
//             a complementarity problem: p >= floor, a domain at the floor first fills its void. A primal-dual active
//             set finds it in a few rounds. A fluid that thins is followed by solving again at the conductances of the
//             pressure drops found (Picard), until they agree.
//             Wellbores with friction (wellbore_flow.hpp) are solved with it: their clusters' rates as they answer to the pressures of
//             the holes, linear in a round and found again after it, until they agree.
//   explicit  the paper's eq. 8 as it stands, sub-cycled below its stability limit V / (K_f sum of conductances).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "flow/flow_matrix.hpp"
#include "flow/fluid_law.hpp"
#include "flow/wellbore_flow.hpp"
#include "linear/conjugate_gradient.hpp"
#include "linear/outside_matrix.hpp"
#include "linear/sparse.hpp"
#include "linear/symmetric_factor.hpp"
#include "model/network.hpp"

namespace hfrac {

class FlowSolver {
 public:
  // `wellbores` are moved along with the network; none: there are no such.
  // `workers` share the equations; none: the calling thread. With a device they run there.
  FlowSolver(const Network& network, const Options& options, std::vector<Wellbore>* wellbores = nullptr,
             const Ranks& ranks = {}, Workers* workers = nullptr, const Device* device = nullptr);

  // Advances contents and pressures by `step` [s]. source[d] [m2/s] is injected into domain d (empty: none).
  // Domains with stiffness 0 keep their pressure. Returns sub-cycles (explicit) or rounds (implicit).
  int advance(Network& network, double step, const std::vector<double>& source);

  // What the step's flows take out of a domain [m2/s].
  [[nodiscard]] double outflow(const Network& network, std::int32_t domain) const {
    return matrix_.outflow(network, domain);
  }

  // Largest stable step of the explicit scheme [s].
  static double explicit_limit(const Network& network);

 private:
  int advance_implicit(Network& network, double step, const std::vector<double>& source);
  // Pressures, flows and what each domain gains at the conductances as they stand; rounds of the active set.
  int solve_step(Network& network, double step, const std::vector<double>& source);
  // A fluid that thins: conductances nearer to those of the pressure drops found. Returns how far off the flows were.
  double follow_thinning(Network& network);
  // Rates of the wellbores' clusters at pressures `p`, into source_; how far off those of the last round were, over what they share.
  double drive_wellbores(const Network& network, const Eigen::VectorXd& p);
  // What the clusters' rates answer to pressures, in the matrix and on the right-hand side.
  void answer_of_wellbores(const Network& network, double step, Eigen::VectorXd& rhs);
  int advance_explicit(Network& network, double step, const std::vector<double>& source);

  // Flows at the pressures found and what each domain gains; whether other domains than before are at the floor.
  bool follow_flow(Network& network, double step, const std::vector<double>& source);

  // matrix_ as it stands, for whoever solves; pressures of that system into p. change: of a pass before (ConjugateGradient::settle).
  void prepare_matrix();
  void solve_pressures(const Eigen::VectorXd& rhs, Eigen::VectorXd& p, double change);
  // The same by conjugate gradients, or by a solver from outside.
  void solve_in_passes(const Eigen::VectorXd& rhs, Eigen::VectorXd& p, double change);
  bool settle_outside(const Eigen::VectorXd& rhs, Eigen::VectorXd& p);
  void list_places();

  bool explicit_;
  bool by_step_, iterative_;  // whether each step chooses; of the step at hand, or of all
  bool analysed_ = false;     // where each step chooses, the factor's pattern
  FluidLaw law_;
  std::vector<double> at_rest_, thinning_;  // per pipe, of a fluid that thins
  double imposed_weight_ = 1.0;
  FlowMatrix matrix_;
  std::vector<Wellbore>* wellbores_;
  std::vector<WellboreFlow> wellbore_flow_;
  std::vector<double> source_;                // m2/s per domain with the clusters' rates
  std::vector<double> hole_, wellbore_rate_;  // Pa and m2/s, of a wellbore's clusters
  std::vector<double> linear_at_;             // Pa, by cluster: pressures about which the rates are linear
  Workers* workers_;
  SymmetricFactor factor_;
  ConjugateGradient conjugate_gradient_;
  std::optional<OutsideMatrix> outside_;
  std::vector<std::int32_t> row_, column_;  // of the entries it gets, until it has them
  std::vector<std::int32_t> entry_;         // where those are in the value array
  std::vector<double> value_;
  Eigen::VectorXd residual_, change_;
  Eigen::VectorXd rhs_, pressure_;
  std::vector<double> fill_;  // m2, content gained in the step
  std::vector<char> cavitated_;
};

}  // namespace hfrac
