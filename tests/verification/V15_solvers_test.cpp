// SPDX-License-Identifier: BSD-3-Clause
// V15: solvers that share nothing but the model agree.
//
// Source     The model itself: what rests does not depend on how rest is found, nor how fluid moves on the scheme.
// Set-up     2 000 discs of Table 1's rock between rigid walls, well of 8.5 m. Elastic: bonds that do not break, 20 MPa put on in
//            four steps, explicit solver to a force ratio of 1e-7 against the quasi-static one. Initiation: the well ramped
//            by 1 MPa a sub-step to 25 MPa, then by 0.25 MPa to the first crack, three packings; explicit against quasi-static, and implicit against
//            explicit flow.
// Tolerance  Displacements and pressures within 0.1 % of the largest, 1 % where contacts slide (friction has more than one
//            equilibrium); initiation within 1 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support.hpp"

namespace V15_solvers {

using verification::Simulation;

hfrac::Definition ramped_rock(int64_t seed) {
  hfrac::Definition def = verification::paper_rock(seed);
  def.wells[0].control = HFRAC_WELL_RAMP;
  return def;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

struct Rock {
  const char* name;
  int64_t contact_mode;
  double friction, tolerance;
};
void compare_fields(const Rock& rock) {
  hfrac::Definition def = ramped_rock(1);
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  def.contact_mode = rock.contact_mode;
  def.contact_friction = rock.friction;
  def.wells[0].pressure = 20e6;
  def.wells[0].ramp_per_step = 5e6;
  def.stepping_force_ratio = 1e-7;
  def.stepping_max_cycles = 200000;
  hfrac::Definition other = def;
  other.solver_kind = 1;
  other.solver_tolerance = 1e-9;
  Simulation by_motion(def), directly(other);
  by_motion.step(4);
  directly.step(4);
  for (const int32_t field : {HFRAC_DISC_DISPLACEMENT, HFRAC_DOMAIN_PRESSURE}) {
    const auto a = by_motion.values(field), b = directly.values(field);
    ASSERT_EQ(a.size(), b.size());
    double size = 0.0;
    for (const double value : b) size = std::max(size, std::abs(value));
    ASSERT_GT(size, 0.0);
    verification::report_absolute(std::string(rock.name) + ": largest difference of " +
                                      (field == HFRAC_DISC_DISPLACEMENT ? "displacement" : "pressure"),
                                  largest_difference(a, b) / size, 0.0, rock.tolerance);
  }
}
// Where contacts slide, what rests depends a little on the way there: friction has more than one equilibrium.
TEST(V15SolversSmoke, GiveTheSameElasticFieldsOfLinearRock) {
  compare_fields({"linear rock", 1, 0.22, 1e-3});
}
TEST(V15Solvers, GiveTheSameElasticFields) {
  compare_fields({"contacts beside bonds", 0, 0.0, 1e-3});
  compare_fields({"the same with friction", 0, 0.22, 1e-2});
}

// Well pressure [Pa] at the first crack.
double initiation(const hfrac_sim_def& def) {
  Simulation sim(def);
  sim.step(25);
  sim.ramp(0, def.wells[0].pressure, 0.25e6);
  while (sim.state().crack_count == 0) {
    if (sim.well(0).pressure >= def.wells[0].pressure) return 0.0;
    sim.step(1);
  }
  return sim.well(0).pressure;
}

TEST(V15Solvers, GiveTheSameInitiationPressure) {
  for (int64_t seed = 1; seed <= 3; ++seed) {
    hfrac::Definition def = ramped_rock(seed);
    def.wells[0].pressure = 80e6;
    def.wells[0].ramp_per_step = 1e6;
    const double explicit_solver = initiation(def);
    def.flow_scheme = 1;
    const double explicit_flow = initiation(def);
    def.flow_scheme = 0;
    def.solver_kind = 1;
    const double quasi_static = initiation(def);
    std::printf("  packing %d: explicit %.2f MPa, quasi-static %.2f MPa, explicit flow %.2f MPa\n",
                static_cast<int>(seed), 1e-6 * explicit_solver, 1e-6 * quasi_static, 1e-6 * explicit_flow);
    verification::Curves curves("V15", "Pressure of the first crack by three ways of solving",
                                "packing,net well pressure (MPa)");
    curves.point("explicit", {static_cast<double>(seed), 1e-6 * explicit_solver});
    curves.point("quasi-static", {static_cast<double>(seed), 1e-6 * quasi_static});
    curves.point("explicit flow", {static_cast<double>(seed), 1e-6 * explicit_flow});
    ASSERT_GT(explicit_solver, 0.0);
    verification::report("first crack: quasi-static against explicit solver, Pa", quasi_static,
                         explicit_solver, 0.01);
    verification::report("first crack: explicit against implicit flow, Pa", explicit_flow, explicit_solver,
                         0.01);
  }
}

}  // namespace V15_solvers
