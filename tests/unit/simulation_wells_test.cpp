// SPDX-License-Identifier: BSD-3-Clause
// How wells are driven: held, ramped, at a rate, and switched between these.
#include <gtest/gtest.h>

#include <cmath>

#include "small_case.hpp"
#include "step/simulation.hpp"

namespace simulation_wells_test {

using namespace testing_unit;

double well_pressure(const Simulation& s) {
  return s.network().pressure[s.wells()[0].place.domain];
}

TEST(Wells, HoldTheirPressure) {
  Simulation s(quiet_case(), {}, {});
  EXPECT_EQ(well_pressure(s), 25e6);
  s.step();
  EXPECT_EQ(well_pressure(s), 30e6);
  const double first = s.wells()[0].injected;
  EXPECT_GT(first, 0.0);
  EXPECT_NEAR(s.wells()[0].rate, first / s.options().stepping_flow_step, 1e-12 * first);
  set_well_pressure(s, 0, 28e6);
  s.step();
  EXPECT_EQ(well_pressure(s), 28e6);
  EXPECT_LT(s.wells()[0].injected, first);
  EXPECT_LE(std::abs(s.balance().fluid_error), 1e-6 * first);
}

TEST(Wells, RampUpAndDownByTheStep) {
  CaseDefinition definition = quiet_case();
  definition.wells[0].control = WellControl::ramp;
  definition.wells[0].ramp_per_step = 2e6;
  Simulation s(definition, {}, {});
  for (const double expected : {27e6, 29e6, 30e6, 30e6}) {
    s.step();
    EXPECT_DOUBLE_EQ(well_pressure(s), expected);
  }
  set_well_ramp(s, 0, 26e6, 3e6);
  for (const double expected : {27e6, 26e6, 26e6}) {
    s.step();
    EXPECT_DOUBLE_EQ(well_pressure(s), expected);
  }
  EXPECT_LE(std::abs(s.balance().fluid_error), 1e-12);
}

TEST(Wells, AtARateTakeExactlyThat) {
  for (const double rate : {1e-2, -1e-2}) {
    CaseDefinition definition = quiet_case();
    definition.options.stepping_flow_step = 3.0;
    definition.wells[0].control = WellControl::rate;
    definition.wells[0].rate = rate;
    Simulation s(definition, {}, {});
    double last = well_pressure(s);
    for (int k = 1; k <= 5; ++k) {
      s.step();
      EXPECT_NEAR(s.wells()[0].injected, k * 3.0 * rate, 1e-14);
      EXPECT_NEAR(s.wells()[0].rate, rate, 1e-14);
      EXPECT_GT((well_pressure(s) - last) / rate, 0.0);
      last = well_pressure(s);
    }
    EXPECT_LE(std::abs(s.balance().fluid_error), 1e-6 * 0.15);
  }
}

TEST(Wells, SwitchBetweenPressureAndRate) {
  Simulation s(quiet_case(), {}, {});
  s.step();
  const double injected = s.wells()[0].injected, pressure = well_pressure(s);
  set_well_rate(s, 0, 0.0);  // shut in
  s.step();
  EXPECT_NEAR(s.wells()[0].injected, injected, 1e-14);
  EXPECT_LE(well_pressure(s), pressure);  // falls by what leaks off
  EXPECT_GT(well_pressure(s), pressure - 1e5);
  set_well_pressure(s, 0, 31e6);
  s.step();
  EXPECT_EQ(well_pressure(s), 31e6);
  EXPECT_LE(std::abs(s.balance().fluid_error), 1e-6 * s.balance().injected);
}

TEST(Wells, CannotGoBelowZeroPressure) {
  Simulation s(quiet_case(), {}, {});
  set_well_pressure(s, 0, -5e6);
  s.step();
  EXPECT_EQ(well_pressure(s), 0.0);
}

TEST(Wells, TwoOfThemKeepTheirOwnBalance) {
  CaseDefinition definition = quiet_case();
  definition.options.packing_disc_count = 900;
  definition.wells[0] = {30.0, 50.0, 8.0};
  definition.wells[0].pressure = 30e6;
  WellOptions second = definition.wells[0];
  second.x = 70.0;
  second.control = WellControl::rate;
  second.rate = 2e-3;
  definition.wells.push_back(second);
  Simulation s(definition, {}, {});
  for (int k = 0; k < 3; ++k) s.step();
  EXPECT_NEAR(s.wells()[1].injected, 6e-3, 1e-14);
  EXPECT_NEAR(s.balance().injected, s.wells()[0].injected + s.wells()[1].injected, 1e-15);
  EXPECT_LE(std::abs(s.balance().fluid_error), 1e-6 * s.balance().injected);
}

}  // namespace simulation_wells_test
