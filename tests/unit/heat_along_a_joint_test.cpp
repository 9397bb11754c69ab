// SPDX-License-Identifier: BSD-3-Clause
// Heat that fluid carries along a joint that conducts, and gives to the rock on both sides.
//
// Lauwerier (1955), as for a fracture: fluid of heat c q flows along a thin plane from x = 0 on, rock conducts across it only:
// T = erfc(lambda x / (c q) / sqrt(D t)), over the step at x = 0, D = lambda over the heat of rock with its fluid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "flow/flow_solver.hpp"
#include "heat/heat_solver.hpp"
#include "model/joint_pores.hpp"
#include "small_case.hpp"

namespace heat_along_a_joint_test {

using namespace testing_unit;

constexpr double height = 50.0, from = 3.0,
                 to = 97.0;  // m; from near the edge, so that hardly any rock lies before it

CaseDefinition jointed_rock() {
  CaseDefinition definition = quiet_case();
  definition.wells.clear();
  Options& o = definition.options;
  o.packing_disc_count = 3000;
  o.contact_mode = choice(ContactMode::after_break);
  o.solver_kind = choice(SolverKind::quasi_static);
  o.stepping_mode = choice(SteppingMode::coupled);
  o.flow_permeability = 1e-24;
  o.fluid_formation_pressure = 10e6;
  o.thermal_mode = static_cast<std::int64_t>(ThermalMode::transport);
  JointOptions joint;
  joint.x1 = from;
  joint.x2 = to;
  joint.y1 = joint.y2 = height;
  joint.state = static_cast<std::int64_t>(JointState::smooth_broken);
  joint.friction = 1.0;
  joint.residual_aperture = 5e-4;
  definition.joints = {joint};
  return definition;
}

TEST(HeatAlongAJoint, FollowsLauwerier) {
  Simulation sim(jointed_rock(), {}, {});
  const Options& o = sim.options();
  const Assembly& a = sim.assembly();
  Network& n = sim.engine().model.network;
  // Steady flow between the joint's first and last contacts.
  const auto at = [&](const SmoothContact& c) { return a.x[a.first[c.bond]] + c.first_arm().x; };
  const auto [first, last] = std::minmax_element(a.smooth.contacts.begin(), a.smooth.contacts.end(),
                                                 [&](const auto& p, const auto& q) { return at(p) < at(q); });
  const auto end = [&](const SmoothContact& c, bool right) {
    const bool forward = n.centroid[n.left[c.bond]].x < n.centroid[n.right[c.bond]].x;
    return forward == right ? n.right[c.bond] : n.left[c.bond];
  };
  const auto inlet = end(*first, false), outlet = end(*last, true);
  const double begin = at(*first) - 0.5 * first->area;
  n.stiffness[inlet] = n.stiffness[outlet] = 0.0;
  n.pressure[inlet] += 1e4;
  FlowSolver flow(n, o);
  const std::vector<double> source(static_cast<std::size_t>(n.domain_count()), 0.0);
  for (int k = 0; k < 3; ++k) flow.advance(n, 1e9, source);
  double rock = 0.0, area = 0.0;  // heat per kelvin, of what lies away from the edge
  HeatNetwork network = build_heat_network(a, n, o);
  for (std::size_t i = 0; i < a.x.size(); ++i) rock += network.capacity[i];
  for (std::size_t d = 1; d < n.volume.size(); ++d)
    rock += n.volume[d] * o.thermal_fluid_density * o.thermal_fluid_specific_heat;
  area = o.model_width * o.model_height;
  // Cold reaches some 8 disc radii into the rock, and much farther along the joint, since Lauwerier has no conduction along it.
  constexpr double deep = 8.0, far = 60.0;
  const double diffusivity = o.thermal_conductivity * area / rock,
               time = deep * deep * a.mean_radius * a.mean_radius / diffusivity,
               wanted = o.thermal_conductivity * far / std::sqrt(diffusivity * time);  // c q, W/(m K)
  const double scale =
      wanted / (o.thermal_fluid_density * o.thermal_fluid_specific_heat) / std::abs(n.flow[first->bond]);
  for (auto& q : n.flow) q *= scale;
  std::fill(n.content.begin(), n.content.end(), 0.0);

  HeatSolver solver(a, n, network, o);
  HeatState state;
  const double start = o.thermal_rock_temperature, drop = -100.0;
  state.disc.assign(a.x.size(), start);
  state.felt = state.disc;
  state.fluid.assign(static_cast<std::size_t>(n.domain_count()), start);
  state.held.assign(a.x.size(), 0);
  state.well = {start + drop};
  constexpr int steps = 100;
  for (int k = 0; k < steps; ++k) solver.advance(state, {inlet}, time / steps);
  double squares = 0.0, length = 0.0;
  for (const auto& c : a.smooth.contacts) {
    const double x = at(c) - begin;
    if (x > far) continue;
    const double found =
        0.5 * (state.fluid[n.left[c.bond]] + state.fluid[n.right[c.bond]] - 2.0 * start) / drop;
    squares += c.area * std::pow(found - std::erfc(x / far), 2.0);
    length += c.area;
  }
  EXPECT_GT(length, 0.9 * far);
  EXPECT_LT(std::sqrt(squares / length), 0.05);  // 0.03
}

}  // namespace heat_along_a_joint_test
