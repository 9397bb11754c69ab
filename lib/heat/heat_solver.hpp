// SPDX-License-Identifier: BSD-3-Clause
// One step of heat: conduction between discs, exchange with the fluid, and what the fluid carries.
//
// Backward Euler on all nodes at once, fluid taken upwind (Patankar 1980), so temperatures stay between those there are
// whatever the step:
//   disc i     C_i (T_i - T_i0) / dt = sum G (T_j - T_i) + sum H (T_d - T_i)
//   domain d   c M_d0 (T_d - T_d0) / dt = sum over inflow c q (T_up - T_d) + sum H (T_i - T_d)
// c is the fluid's density times specific heat, q the flow of the step, M_d0 what the pore held before it, as an area:
// pore volume and content (eq. 8). With the mass balance M_d - M_d0 = dt sum q this is the balance of the heat c M T of what
// the pore holds, to rounding.
//   wells      that feed the rock have the injected temperature; others mix what flows in
//   outside    fluid comes in at the temperature of the rock before injection
//   held discs keep theirs
// The matrix is diagonally dominant, so stabilised bi-conjugate gradients (van der Vorst 1992) with its diagonal soon find
// the change of temperature, in less time than a factorisation. Should they fail, it is factorised after all. The pattern is
// made once.
#pragma once

#include <cstdint>
#include <vector>

#include "heat/heat_network.hpp"
#include "linear/sparse.hpp"
#include "model/assembly.hpp"
#include "model/heat_state.hpp"
#include "model/network.hpp"

namespace hfrac {

class HeatSolver {
 public:
  HeatSolver(const Assembly& assembly, const Network& network, const HeatNetwork& heat,
             const Options& options);

  // Temperatures after `duration` [s] of the flow now in network.flow, which has already moved the contents. `well_domain`
  // are the wells' domains in the order of state.well.
  void advance(HeatState& state, const std::vector<std::int32_t>& well_domain, double duration);

  // Heat that rock and pores hold beyond that after the initial equilibration [J/m].
  [[nodiscard]] double stored(const HeatState& state) const;
  // Of one domain's fluid per kelvin, now [J/(m K)].
  [[nodiscard]] double fluid_capacity(std::size_t domain) const;

 private:
  using Matrix = SparseMatrix;
  void choose_fixed(const HeatState& state, const std::vector<std::int32_t>& well_domain);
  void fill(const HeatState& state, double duration);
  void solve();
  void accumulate(HeatState& state, double duration) const;
  [[nodiscard]] double carried(std::size_t pipe) const { return carrier_ * network_.flow[pipe]; }  // W/(m K)

  const Assembly& assembly_;
  const Network& network_;
  const HeatNetwork& heat_;
  double start_;    // K, at set-up
  double carrier_;  // J/(m3 K): density times specific heat of the fluid
  std::size_t discs_ = 0, nodes_ = 0;
  bool wet_;
  Matrix matrix_;
  // places in the value array: diagonal per node; (first, second) and (second, first) per bond, (disc, domain) and (domain, disc)
  // per corner, (left, right) and (right, left) per pipe
  std::vector<std::int32_t> diagonal_, bond_place_, face_place_, pipe_place_;
  BiconjugateGradients gradients_;
  OrderedFactor factor_;
  bool analysed_ = false;
  Eigen::VectorXd rhs_, temperature_, residual_, change_;
  std::vector<char> fixed_;       // per node: keeps its temperature in this step
  std::vector<double> fixed_at_;  // K
  std::vector<double> net_;       // m2/s per domain, what flows in
};

}  // namespace hfrac
