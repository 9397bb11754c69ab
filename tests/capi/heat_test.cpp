// SPDX-License-Identifier: BSD-3-Clause
// Temperature as a host sets and reads it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "sim_support.hpp"

namespace heat_test {

using namespace testing_capi;

constexpr double rock = 573.15, cold = 293.15;

hfrac::Definition hot_def(int64_t mode = 2) {
  hfrac::Definition def = quiet_def();
  def.thermal_mode = mode;
  def.thermal_rock_temperature = rock;
  def.thermal_fluid_temperature = cold;
  def.thermal_expansion = 1e-5;
  def.wells[0].pressure = 31e6;
  def.stepping_flow_step = 1e5;
  return def;
}

hfrac_heat heat_of(const hfrac_sim* sim) {
  return read_struct<hfrac_heat>([&](auto* to) { return hfrac_get_heat(sim, to); });
}

double temperature_of_well(const hfrac_sim* sim) {
  double kelvin = 0.0;
  EXPECT_EQ(hfrac_well_get_temperature(sim, 0, &kelvin), HFRAC_OK) << last_error(sim);
  return kelvin;
}

TEST(Heat, AColdWellCoolsTheRockAndTheBalanceCloses) {
  Sim sim(hot_def());
  EXPECT_EQ(temperature_of_well(sim), rock);
  ASSERT_GE(hfrac_step(sim, 3), 0) << last_error(sim);
  EXPECT_EQ(temperature_of_well(sim), cold);
  const hfrac_heat heat = heat_of(sim);
  EXPECT_EQ(heat.mode, 2);
  EXPECT_LT(heat.wells, 0.0);
  EXPECT_LT(std::abs(heat.error), 1e-9 * std::abs(heat.wells));
  const auto discs = doubles(sim, HFRAC_DISC_TEMPERATURE), domains = doubles(sim, HFRAC_DOMAIN_TEMPERATURE);
  EXPECT_EQ(*std::min_element(discs.begin(), discs.end()), heat.lowest);
  EXPECT_EQ(*std::max_element(discs.begin(), discs.end()), heat.highest);
  EXPECT_LT(heat.lowest, rock - 1.0);
  EXPECT_EQ(*std::min_element(domains.begin(), domains.end()), cold);
}

TEST(Heat, DiscsKeepWhatTheyAreGivenAndHeldOnesForGood) {
  Sim sim(hot_def());
  auto wanted = doubles(sim, HFRAC_DISC_TEMPERATURE);
  const auto count = static_cast<int64_t>(wanted.size());
  std::vector<int32_t> held(wanted.size(), 0);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    wanted[i] = rock + static_cast<double>(i % 10);
    held[i] = i % 50 == 0 ? 1 : 0;
  }
  ASSERT_EQ(hfrac_set_disc_temperature(sim, wanted.data(), count), HFRAC_OK) << last_error(sim);
  ASSERT_EQ(hfrac_hold_disc_temperature(sim, held.data(), count), HFRAC_OK) << last_error(sim);
  EXPECT_EQ(doubles(sim, HFRAC_DISC_TEMPERATURE), wanted);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  const auto after = doubles(sim, HFRAC_DISC_TEMPERATURE);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (held[i] == 0) continue;
    EXPECT_EQ(after[i], wanted[i]);
  }
  EXPECT_NE(after, wanted);
  EXPECT_NE(heat_of(sim).held, 0.0);
}

TEST(Heat, CellsOfTheHostsGridGoInAndOut) {
  Sim sim(hot_def());
  hfrac_grid grid{};
  grid.struct_size = sizeof grid;
  grid.nx = 2;
  grid.ny = 1;
  grid.dx = 50.0;
  grid.dy = 100.0;
  const double wanted[2] = {500.0, 600.0};
  EXPECT_EQ(hfrac_set_cell_temperature(sim, wanted, 2), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("hfrac_set_grid"), std::string::npos);
  ASSERT_EQ(hfrac_set_grid(sim, &grid), HFRAC_OK);
  ASSERT_EQ(hfrac_set_cell_temperature(sim, wanted, 2), HFRAC_OK) << last_error(sim);
  double read[2] = {0.0, 0.0};
  int64_t count = 0;
  ASSERT_EQ(hfrac_get_cell_temperature(sim, nullptr, 0, &count), HFRAC_OK);
  EXPECT_EQ(count, 2);
  ASSERT_EQ(hfrac_get_cell_temperature(sim, read, 2, &count), HFRAC_OK);
  EXPECT_NEAR(read[0], wanted[0], 1e-9);
  EXPECT_NEAR(read[1], wanted[1], 1e-9);
  const auto position = doubles(sim, HFRAC_DISC_POSITION), discs = doubles(sim, HFRAC_DISC_TEMPERATURE);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (std::abs(position[2 * i] - 50.0) < 1.0) continue;
    EXPECT_EQ(discs[i], position[2 * i] < 50.0 ? wanted[0] : wanted[1]);
  }
  const hfrac_heat heat = heat_of(sim);
  EXPECT_LT(std::abs(heat.error), 1e-9 * std::abs(heat.host));
  EXPECT_EQ(hfrac_set_cell_temperature(sim, wanted, 1), HFRAC_ERR_ARGUMENT);
}

TEST(Heat, ChangingTheTemperatureWhileRunningMovesTheRock) {
  hfrac::Definition def = hot_def(1);
  def.flow_scheme = 2;  // dry: fluid in pores would resist at first
  Sim sim(def);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  const auto before = doubles(sim, HFRAC_DISC_DISPLACEMENT);
  ASSERT_EQ(hfrac_set_temperature(sim, rock + 100.0), HFRAC_OK) << last_error(sim);
  EXPECT_EQ(doubles(sim, HFRAC_DISC_DISPLACEMENT), before);  // felt in the next step
  ASSERT_GE(hfrac_step(sim, 1), 0);
  EXPECT_EQ(heat_of(sim).lowest, rock + 100.0);
  const auto after = doubles(sim, HFRAC_DISC_DISPLACEMENT);
  const auto position = doubles(sim, HFRAC_DISC_POSITION);
  double outwards = 0.0, way = 0.0;
  for (std::size_t i = 0; i < after.size() / 2; ++i) {
    const double x = position[2 * i] - 50.0;
    if (std::abs(x) < 30.0) continue;
    outwards += (after[2 * i] - before[2 * i]) / x;
    way += 1.0;
  }
  EXPECT_NEAR(outwards / way, 1e-5 * 100.0, 2e-4);  // alpha dT: free under its far field
}

TEST(Heat, AWellsTemperatureHoldsThroughTheTriesOfAStep) {
  Sim sim(hot_def());
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  ASSERT_GE(hfrac_step_do(sim, 1e5), 0);
  ASSERT_EQ(hfrac_well_set_temperature(sim, 0, 350.0), HFRAC_OK) << last_error(sim);
  EXPECT_EQ(hfrac_set_temperature(sim, 600.0), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("hfrac_step_prepare"), std::string::npos);
  ASSERT_GE(hfrac_step_do(sim, 1e5), 0);
  EXPECT_EQ(temperature_of_well(sim), 350.0);
  ASSERT_EQ(hfrac_step_finalize(sim), HFRAC_OK);
  EXPECT_GE(heat_of(sim).lowest, 350.0);
}

TEST(Heat, RefusesWhatItCannotTakeAndChangesNothing) {
  Sim sim(hot_def());
  const auto hash = hash_of(sim);
  const auto count = static_cast<int64_t>(doubles(sim, HFRAC_DISC_TEMPERATURE).size());
  std::vector<double> wanted(static_cast<std::size_t>(count), rock);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -1.0, 0.0, 1e9}) {
    EXPECT_EQ(hfrac_set_temperature(sim, bad), HFRAC_ERR_ARGUMENT);
    EXPECT_EQ(hfrac_well_set_temperature(sim, 0, bad), HFRAC_ERR_ARGUMENT);
    wanted.back() = bad;
    EXPECT_EQ(hfrac_set_disc_temperature(sim, wanted.data(), count), HFRAC_ERR_ARGUMENT);
    EXPECT_NE(last_error(sim).find("273.15"), std::string::npos) << last_error(sim);
  }
  EXPECT_EQ(hfrac_set_disc_temperature(sim, wanted.data(), count - 1), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_disc_temperature(sim, nullptr, count), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_disc_temperature(sim, wanted.data(), -1), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_hold_disc_temperature(sim, nullptr, count), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_well_set_temperature(sim, 1, rock), HFRAC_ERR_ARGUMENT);
  double kelvin = 0.0;
  EXPECT_EQ(hfrac_well_get_temperature(sim, -1, &kelvin), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hash_of(sim), hash);
}

TEST(Heat, TheTableRefusesTemperaturesOutsideIt) {
  hfrac::Definition def = hot_def(1);
  def.thermal_parameters = 1;
  Sim sim(def);
  EXPECT_EQ(hfrac_set_temperature(sim, 673.15), HFRAC_OK) << last_error(sim);
  EXPECT_EQ(hfrac_set_temperature(sim, 680.0), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("thermal.temperature_1"), std::string::npos) << last_error(sim);
}

TEST(Heat, ASimulationWithoutTemperatureSaysSo) {
  Sim sim(quiet_def());
  double kelvin = 0.0;
  hfrac_heat heat{};
  heat.struct_size = sizeof heat;
  for (const int32_t status : {hfrac_set_temperature(sim, rock), hfrac_well_set_temperature(sim, 0, rock),
                               hfrac_well_get_temperature(sim, 0, &kelvin), hfrac_get_heat(sim, &heat)})
    EXPECT_EQ(status, HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("thermal.mode"), std::string::npos);
  for (const double one : doubles(sim, HFRAC_DISC_TEMPERATURE)) ASSERT_EQ(one, 523.15);
}

TEST(Heat, AnImageOfAnotherModeIsRefused) {
  Sim hot(hot_def()), plain(quiet_def());
  int64_t size = 0;
  ASSERT_EQ(hfrac_state_size(hot, &size), HFRAC_OK);
  std::vector<char> image(static_cast<std::size_t>(size));
  ASSERT_EQ(hfrac_state_save(hot, image.data(), size, &size), HFRAC_OK);
  const auto hash = hash_of(plain);
  EXPECT_LT(hfrac_state_restore(plain, image.data(), size), 0);
  EXPECT_EQ(hash_of(plain), hash);
}

}  // namespace heat_test
