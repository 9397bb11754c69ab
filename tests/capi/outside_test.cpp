// SPDX-License-Identifier: BSD-3-Clause
// What acts from outside while running: the formation's pressure, walls, and what limits a step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_support.hpp"

namespace outside_test {

using namespace testing_capi;

// A shut well in rock that holds; steps long enough for pressure to cross the model.
hfrac::Definition patient_def() {
  hfrac::Definition def = quiet_def(300);
  def.stepping_flow_step = 5e8;
  def.wells[0].control = HFRAC_WELL_RATE;
  def.wells[0].rate = 0.0;
  return def;
}

TEST(FormationPressure, PoresInsideFollowTheOutside) {
  const Sim sim(patient_def());
  EXPECT_EQ(state_of(sim).formation_pressure, 25e6);
  ASSERT_EQ(hfrac_set_formation_pressure(sim, 28e6), HFRAC_OK) << last_error(sim);
  EXPECT_EQ(state_of(sim).formation_pressure, 28e6);
  const double before = doubles(sim, HFRAC_DOMAIN_PRESSURE).back();
  ASSERT_GE(hfrac_step(sim, 20), 0) << last_error(sim);
  const auto pressure = doubles(sim, HFRAC_DOMAIN_PRESSURE);
  EXPECT_EQ(pressure[0], 28e6);
  EXPECT_LT(before, 27e6);
  double farthest = 0.0;
  for (const double p : pressure) farthest = std::max(farthest, std::abs(p - 28e6));
  EXPECT_LT(farthest, 0.01 * 3e6);

  // What came in through the boundary is stored, and the energy balance counts the work done outside.
  const hfrac_balance balance = balance_of(sim);
  EXPECT_GT(balance.stored_volume, 0.0);
  EXPECT_NEAR(balance.leaked_volume, -balance.stored_volume, 1e-6 * balance.stored_volume);
  EXPECT_NEAR(balance.energy_error, 0.0, 1e-2 * std::abs(balance.fluid_work));
}

// Under the same total stress, more pressure in the pores leaves less for the rock: it grows, as if the far field had been
// lowered by the same amount.
TEST(FormationPressure, TotalStressesStay) {
  const auto area = [](hfrac_sim* sim) {
    const auto u = doubles(sim, HFRAC_DISC_DISPLACEMENT), x = doubles(sim, HFRAC_DISC_POSITION);
    double sum = 0.0;  // how far discs moved away from the middle
    for (std::size_t k = 0; k < x.size(); k += 2) sum += u[k] * (x[k] - 50.0) + u[k + 1] * (x[k + 1] - 50.0);
    return sum;
  };
  const Sim sim(patient_def());
  ASSERT_EQ(hfrac_set_formation_pressure(sim, 28e6), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 6), 0);
  EXPECT_GT(area(sim), 0.0);
  const Sim relieved(patient_def());
  ASSERT_EQ(hfrac_set_far_field(relieved, 27e6, 27e6), HFRAC_OK);
  ASSERT_GE(hfrac_step(relieved, 6), 0);
  EXPECT_NEAR(area(sim), area(relieved), 0.02 * area(relieved));
}

TEST(FormationPressure, GoesBackWithARejectedStepAndWithAState) {
  const Sim sim(patient_def());
  const int64_t before = hash_of(sim);
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  ASSERT_EQ(hfrac_set_formation_pressure(sim, 27e6), HFRAC_OK);
  ASSERT_GE(hfrac_step_do(sim, 1e7), 0);
  EXPECT_EQ(state_of(sim).formation_pressure, 27e6);
  const int64_t once = hash_of(sim);
  ASSERT_GE(hfrac_step_do(sim, 1e7), 0);
  EXPECT_EQ(hash_of(sim), once) << "the host's setting holds for every try";
  ASSERT_EQ(hfrac_step_reject(sim), HFRAC_OK);
  EXPECT_EQ(hash_of(sim), before);
  EXPECT_EQ(state_of(sim).formation_pressure, 25e6);

  ASSERT_EQ(hfrac_set_formation_pressure(sim, 27e6), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 2), 0);
  std::vector<unsigned char> image;
  int64_t size = 0;
  ASSERT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
  image.resize(static_cast<std::size_t>(size));
  ASSERT_EQ(hfrac_state_save(sim, image.data(), size, nullptr), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 2), 0);
  const Sim other(patient_def());
  ASSERT_EQ(hfrac_state_restore(other, image.data(), size), HFRAC_OK);
  EXPECT_EQ(state_of(other).formation_pressure, 27e6);
  ASSERT_GE(hfrac_step(other, 2), 0);
  EXPECT_EQ(hash_of(other), hash_of(sim));
  EXPECT_NEAR(balance_of(other).energy_error, balance_of(sim).energy_error,
              1e-9 * std::abs(balance_of(sim).boundary_work));
}

TEST(FormationPressure, InTheEffectiveConventionPressuresStayNetOfTheDefinition) {
  hfrac::Definition def = cracking_def(300);
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  def.wells[0].control = HFRAC_WELL_RATE;
  def.stepping_flow_step = 5e8;
  const Sim sim(def);
  ASSERT_EQ(hfrac_set_formation_pressure(sim, 26e6), HFRAC_OK) << last_error(sim);
  ASSERT_GE(hfrac_step(sim, 6), 0);
  double farthest = 0.0;
  for (const double p : doubles(sim, HFRAC_DOMAIN_PRESSURE)) farthest = std::max(farthest, std::abs(p - 1e6));
  EXPECT_LT(farthest, 0.01 * 1e6);
}

TEST(FormationPressure, IsRefusedWhereItCannotAct) {
  const Sim sim(patient_def());
  const int64_t before = hash_of(sim);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double p : {nan, std::numeric_limits<double>::infinity(), -1.0, 1e11, 31e6}) {
    EXPECT_EQ(hfrac_set_formation_pressure(sim, p), HFRAC_ERR_ARGUMENT) << p;
    EXPECT_FALSE(last_error(sim).empty());
  }
  EXPECT_EQ(hash_of(sim), before);
  hfrac::Definition def = quiet_def(300);
  def.flow_outer = 1;  // closed
  const Sim closed(def);
  EXPECT_EQ(hfrac_set_formation_pressure(closed, 26e6), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(closed).find("flow.outer"), std::string::npos);
  def = quiet_def(300);
  def.flow_scheme = 2;  // off
  const Sim dry(def);
  EXPECT_EQ(hfrac_set_formation_pressure(dry, 26e6), HFRAC_ERR_ARGUMENT);
}

TEST(Walls, CarryTheFarFieldAndAreWhereTheyWerePut) {
  hfrac::Definition def = quiet_def();
  def.boundary_kind = 1;
  def.boundary_walls_after_equilibration = 1;
  def.stress_sigma_Hmax = 40e6;
  def.stepping_force_ratio = 1e-5;
  const Sim sim(def);
  ASSERT_GE(hfrac_step(sim, 2), 0);
  int32_t count = 0;
  ASSERT_EQ(hfrac_wall_count(sim, &count), HFRAC_OK);
  ASSERT_EQ(count, 4);
  const double places[] = {0.0, 100.0, 0.0, 100.0};
  for (int32_t w = 0; w < 4; ++w) {
    const auto wall = read_struct<hfrac_wall_state>([&](auto* to) { return hfrac_wall_get(sim, w, to); });
    EXPECT_EQ(wall.moves, 1);
    EXPECT_EQ(wall.target, (w < 2 ? 40e6 : 30e6) - 25e6) << "effective";
    EXPECT_NEAR(wall.stress, wall.target, 0.01 * wall.target);
    EXPECT_EQ(wall.normal[w / 2], w % 2 == 0 ? 1.0 : -1.0);
    EXPECT_EQ(wall.normal[1 - w / 2], 0.0);
    EXPECT_NEAR(wall.position, places[w], 1.0);
    EXPECT_EQ(wall.position, places[w] + wall.normal[w / 2] * wall.displacement);
    EXPECT_GT(wall.disc_count, 5);
  }
  hfrac_wall_state wall{};
  wall.struct_size = sizeof wall;
  EXPECT_EQ(hfrac_wall_get(sim, 4, &wall), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_wall_get(sim, -1, &wall), HFRAC_ERR_ARGUMENT);

  const Sim open(quiet_def());
  ASSERT_EQ(hfrac_wall_count(open, &count), HFRAC_OK);
  EXPECT_EQ(count, 0);
  EXPECT_EQ(hfrac_wall_get(open, 0, &wall), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(open).find("boundary.kind"), std::string::npos);
}

TEST(StepLimits, NameWhatBinds) {
  const auto limits_of = [](const hfrac_sim_def& def) {
    const Sim sim(def);
    return read_struct<hfrac_step_limits>([&](auto* to) { return hfrac_get_step_limits(sim, to); });
  };
  hfrac::Definition def = quiet_def();
  def.stepping_flow_step = 1e4;
  hfrac_step_limits limits = limits_of(def);
  EXPECT_EQ(limits.binding, HFRAC_LIMIT_NONE) << "implicit flow, rock at rest";
  EXPECT_EQ(limits.flow_step, 1e4);
  EXPECT_GT(limits.mechanical_step, 1e-6);
  EXPECT_LT(limits.mechanical_step, 1e-2);
  EXPECT_GT(limits.explicit_step, limits.mechanical_step);
  def.flow_scheme = 1;
  EXPECT_EQ(limits_of(def).binding, HFRAC_LIMIT_FLOW);
  def.stepping_flow_step = 1e-3 * limits.explicit_step;
  EXPECT_EQ(limits_of(def).binding, HFRAC_LIMIT_NONE) << "shorter than its sub-cycles would be";
  def.stepping_mode = 1;
  def.stepping_flow_step = 10.0 * limits.mechanical_step;
  EXPECT_EQ(limits_of(def).binding, HFRAC_LIMIT_MECHANICS);
}

// The limit is the one the solver keeps: a step just below half of it takes one sub-cycle, one above it two.
TEST(StepLimits, TheFlowLimitIsTheSolversOwn) {
  hfrac::Definition def = quiet_def();
  def.flow_scheme = 1;
  const Sim sim(def);
  const auto limits =
      read_struct<hfrac_step_limits>([&](auto* to) { return hfrac_get_step_limits(sim, to); });
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  ASSERT_GE(hfrac_step_do(sim, 0.49 * limits.explicit_step), 0);
  EXPECT_EQ(state_of(sim).flow_subcycles, 1);
  ASSERT_GE(hfrac_step_do(sim, 0.51 * limits.explicit_step), 0);
  EXPECT_EQ(state_of(sim).flow_subcycles, 2);
}

}  // namespace outside_test
