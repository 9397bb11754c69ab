// SPDX-License-Identifier: BSD-3-Clause
// Wells while a simulation runs: held, ramped, at a rate, and changed from one to another.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "sim_support.hpp"

namespace well_test {

using namespace testing_capi;

TEST(WellState, TellsTheRadiusAskedForFromTheOneItGot) {
  const Sim sim(quiet_def());
  EXPECT_EQ(well_of(sim).radius, 10.0);
  EXPECT_NE(well_of(sim).equivalent_radius, 10.0);
  EXPECT_NEAR(well_of(sim).equivalent_radius, 10.0, 4.0);
}

TEST(Well, IsAsDefined) {
  hfrac::Definition def = quiet_def();
  def.wells[0].x = 45.0;
  const Sim sim(def);
  int32_t count = 0;
  ASSERT_EQ(hfrac_well_count(sim, &count), HFRAC_OK);
  EXPECT_EQ(count, 1);
  const auto well = well_of(sim);
  EXPECT_EQ(well.control, HFRAC_WELL_PRESSURE);
  EXPECT_EQ(well.x, 45.0);
  EXPECT_EQ(well.y, 50.0);
  EXPECT_GT(well.equivalent_radius, 10.0);
  EXPECT_LT(well.equivalent_radius, 16.0);
  EXPECT_EQ(well.target_pressure, 30e6);
  EXPECT_EQ(well.injected_volume, 0.0);
  EXPECT_EQ(indices(sim, HFRAC_DOMAIN_KIND)[static_cast<std::size_t>(well.domain)], 1);
}

TEST(Well, IsHeldAtItsPressure) {
  const Sim sim(quiet_def());
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_EQ(well_of(sim).pressure, 30e6);
  const double injected = well_of(sim).injected_volume;
  EXPECT_GT(injected, 0.0);
  EXPECT_NEAR(well_of(sim).rate, injected, 1e-12);
  ASSERT_EQ(hfrac_well_set_pressure(sim, 0, 27e6), HFRAC_OK);
  EXPECT_EQ(well_of(sim).pressure, 30e6);  // from the next step on
  EXPECT_EQ(well_of(sim).target_pressure, 27e6);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_EQ(well_of(sim).pressure, 27e6);
  EXPECT_LT(well_of(sim).injected_volume, injected);
}

TEST(Well, TellsThePressuresOfWellboreAndWellhead) {
  hfrac::Definition def = quiet_def();
  def.wells[0].control = HFRAC_WELL_RATE;
  def.wells[0].rate = 2e-3;
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "well[0].near_well_friction", 1e7), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "well[0].height", 5.0), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "well[0].depth", 1000.0), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_def_set_i64(&def, "well[0].wellbore", 7), HFRAC_OK);
  int64_t number = 0;
  ASSERT_EQ(hfrac_sim_def_get_i64(&def, "well[0].wellbore", &number), HFRAC_OK);
  EXPECT_EQ(number, 7);
  const Sim sim(def);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  const auto well = well_of(sim);
  EXPECT_GT(well.wellbore_pressure, well.pressure + 0.99e6);  // 1e7 sqrt(5 * 2e-3)
  EXPECT_NEAR(well.wellhead_pressure, well.wellbore_pressure - 1000.0 * 9.80665 * 1000.0, 1e-3);
  EXPECT_NEAR(well.wellbore_rate, 2e-3, 1e-15);
  EXPECT_NEAR(well.rate, 2e-3, 1e-15);
}

// Half the area, twice the rise: the fluid is far softer than the rock.
TEST(Well, HoldsTheAreaOfFluidThatItIsGiven) {
  double rise[2] = {};
  for (const int k : {0, 1}) {
    hfrac::Definition def = quiet_def();
    def.wells[0].control = HFRAC_WELL_RATE;
    def.wells[0].rate = 0.5;
    def.flow_permeability = 1e-22;
    def.fluid_bulk_modulus = 1e7;
    ASSERT_EQ(hfrac_sim_def_set_f64(&def, "well[0].fluid_area", k == 0 ? 200.0 : 100.0), HFRAC_OK);
    const Sim sim(def);
    const double before = well_of(sim).pressure;
    ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
    rise[k] = well_of(sim).pressure - before;
  }
  EXPECT_NEAR(rise[1] / rise[0], 2.0, 0.02);
}

TEST(Well, RampsUpAndDown) {
  hfrac::Definition def = quiet_def();
  def.wells[0].control = HFRAC_WELL_RAMP;
  def.wells[0].ramp_per_step = 2e6;
  const Sim sim(def);
  for (const double expected : {27e6, 29e6, 30e6, 30e6}) {
    ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
    EXPECT_DOUBLE_EQ(well_of(sim).pressure, expected);
  }
  ASSERT_EQ(hfrac_well_set_ramp(sim, 0, 26e6, 3e6), HFRAC_OK);
  EXPECT_EQ(well_of(sim).control, HFRAC_WELL_RAMP);
  for (const double expected : {27e6, 26e6, 26e6}) {
    ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
    EXPECT_DOUBLE_EQ(well_of(sim).pressure, expected);
  }
}

TEST(Well, TakesItsRate) {
  for (const double rate : {2e-3, -2e-3}) {
    hfrac::Definition def = quiet_def();
    def.stepping_flow_step = 0.5;
    def.wells[0].control = HFRAC_WELL_RATE;
    def.wells[0].rate = rate;
    const Sim sim(def);
    for (int k = 1; k <= 4; ++k) {
      ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
      EXPECT_NEAR(well_of(sim).injected_volume, rate * state_of(sim).time, 1e-15);
      EXPECT_NEAR(well_of(sim).rate, rate, 1e-14);
    }
    EXPECT_GT((well_of(sim).pressure - 25e6) / rate, 0.0);
    EXPECT_EQ(balance_of(sim).injected_volume, well_of(sim).injected_volume);
  }
}

TEST(Well, ChangesItsControlWhileRunning) {
  const Sim sim(quiet_def());
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  const double injected = well_of(sim).injected_volume;
  ASSERT_EQ(hfrac_well_set_rate(sim, 0, 0.0), HFRAC_OK);  // shut in
  EXPECT_EQ(well_of(sim).control, HFRAC_WELL_RATE);
  ASSERT_EQ(hfrac_step(sim, 2), HFRAC_OK);
  EXPECT_NEAR(well_of(sim).injected_volume, injected, 1e-15);
  EXPECT_LE(well_of(sim).pressure, 30e6);
  ASSERT_EQ(hfrac_well_set_rate(sim, 0, 1e-3), HFRAC_OK);
  ASSERT_EQ(hfrac_step(sim, 3), HFRAC_OK);
  EXPECT_NEAR(well_of(sim).injected_volume, injected + 3e-3, 1e-14);
  const double before = well_of(sim).pressure;
  ASSERT_EQ(hfrac_well_set_ramp(sim, 0, before + 1e6, 4e5), HFRAC_OK);  // from where it is
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_NEAR(well_of(sim).pressure, before + 4e5, 1.0);
  ASSERT_EQ(hfrac_well_set_pressure(sim, 0, 30e6), HFRAC_OK);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_EQ(well_of(sim).pressure, 30e6);
  EXPECT_LE(std::abs(balance_of(sim).fluid_error), 1e-6 * balance_of(sim).injected_volume);
}

TEST(Well, EachHasItsOwn) {
  hfrac::Definition def = quiet_def(800);
  hfrac_sim_def_set_i64(&def, "well_count", 2);
  def.wells[0].x = 30.0;
  def.wells[0].radius = 8.0;
  def.wells[1] = def.wells[0];
  def.wells[1].x = 70.0;
  def.wells[1].control = HFRAC_WELL_RATE;
  def.wells[1].rate = 1e-3;
  const Sim sim(def);
  ASSERT_EQ(hfrac_step(sim, 2), HFRAC_OK);
  EXPECT_NE(well_of(sim, 0).domain, well_of(sim, 1).domain);
  EXPECT_EQ(well_of(sim, 0).pressure, 30e6);
  EXPECT_NEAR(well_of(sim, 1).injected_volume, 2e-3, 1e-15);
  EXPECT_NEAR(balance_of(sim).injected_volume,
              well_of(sim, 0).injected_volume + well_of(sim, 1).injected_volume, 1e-15);
  ASSERT_EQ(hfrac_well_set_pressure(sim, 1, 28e6), HFRAC_OK);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_EQ(well_of(sim, 0).pressure, 30e6);
  EXPECT_EQ(well_of(sim, 1).pressure, 28e6);
}

std::vector<unsigned char> image_of(const hfrac_sim* sim) {
  int64_t size = 0;
  EXPECT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
  std::vector<unsigned char> image(static_cast<std::size_t>(size));
  EXPECT_EQ(hfrac_state_save(sim, image.data(), size, &size), HFRAC_OK);
  return image;
}

int32_t remember(void* user, int32_t level, const char* message) {
  *static_cast<std::string*>(user) += std::to_string(level) + message + "\n";
  return 0;
}

TEST(Well, IsAddedToALivingSimulation) {
  const Sim sim(quiet_def());
  std::string heard;
  ASSERT_EQ(hfrac_set_log(sim, remember, &heard, HFRAC_LOG_INFO), HFRAC_OK);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  const auto before = image_of(sim);
  const int64_t hash = hash_of(sim);
  for (int32_t number = 1; number < 12; ++number) {  // any number of them
    int32_t index = 0;
    const int64_t epoch = epoch_of(sim);
    ASSERT_EQ(hfrac_well_add(sim, 20.0 + 5.0 * number, 20.0, &index), HFRAC_OK) << last_error(sim);
    EXPECT_EQ(index, number);
    EXPECT_GT(epoch_of(sim), epoch);
    const auto well = well_of(sim, index);
    EXPECT_EQ(well.control, HFRAC_WELL_RATE);
    EXPECT_EQ(well.rate, 0.0);
    EXPECT_EQ(well.radius, 0.0);
    EXPECT_GT(well.equivalent_radius, 0.0);
    EXPECT_NEAR(well.x, 20.0 + 5.0 * number, 4.0);
    EXPECT_NEAR(well.y, 20.0, 4.0);
    EXPECT_EQ(indices(sim, HFRAC_DOMAIN_KIND)[static_cast<std::size_t>(well.domain)], 1);
    ASSERT_EQ(hfrac_well_set_pressure(sim, index, 26e6), HFRAC_OK);
  }
  EXPECT_NE(heard.find("3well 1: added in domain"), std::string::npos) << heard;
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  double injected = 0.0;
  for (int32_t index = 0; index < 12; ++index) injected += well_of(sim, index).injected_volume;
  EXPECT_EQ(well_of(sim, 11).pressure, 26e6);
  EXPECT_GT(well_of(sim, 11).rate, 0.0);
  EXPECT_NEAR(balance_of(sim).injected_volume, injected, 1e-12 * injected);
  EXPECT_LE(std::abs(balance_of(sim).fluid_error), 1e-12 * injected);

  hfrac::Definition built;
  ASSERT_EQ(hfrac_sim_definition(sim, &built), HFRAC_OK);
  EXPECT_EQ(built.well_count, 1);
  const auto with = image_of(sim);
  const Sim other(built);
  ASSERT_EQ(hfrac_state_restore(other, with.data(), static_cast<int64_t>(with.size())), HFRAC_OK)
      << last_error(other);
  EXPECT_EQ(hash_of(other), hash_of(sim));
  EXPECT_EQ(well_of(other, 11).pressure, 26e6);

  heard.clear();
  ASSERT_EQ(hfrac_state_restore(sim, before.data(), static_cast<int64_t>(before.size())), HFRAC_OK);
  EXPECT_EQ(hash_of(sim), hash);
  EXPECT_NE(heard.find("2the restored state has 1 wells: those added since"), std::string::npos) << heard;
  ASSERT_EQ(hfrac_state_restore(sim, with.data(), static_cast<int64_t>(with.size())), HFRAC_OK);
  EXPECT_NE(heard.find("3the restored state has 12 wells"), std::string::npos) << heard;
}

TEST(Well, IsNotAddedWhereThereIsNoPore) {
  const Sim sim(quiet_def());
  const int64_t hash = hash_of(sim), epoch = epoch_of(sim);
  int32_t index = 77;
  const auto refused = [&](double x, double y, const char* words) {
    EXPECT_EQ(hfrac_well_add(sim, x, y, &index), HFRAC_ERR_ARGUMENT);
    EXPECT_NE(last_error(sim).find(words), std::string::npos) << last_error(sim);
    EXPECT_EQ(index, 77);
  };
  refused(-5.0, 50.0, "outside the rock");
  refused(50.0, 50.0, "well 0");
  refused(std::nan(""), 50.0, "finite");
  EXPECT_EQ(hfrac_well_add(sim, 75.0, 60.0, nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hash_of(sim), hash);
  EXPECT_EQ(epoch_of(sim), epoch);
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  refused(75.0, 60.0, "a step is open");
  ASSERT_EQ(hfrac_step_reject(sim), HFRAC_OK);
  EXPECT_EQ(hfrac_well_add(sim, 75.0, 60.0, &index), HFRAC_OK);
  EXPECT_EQ(hfrac_well_add(nullptr, 75.0, 60.0, &index), HFRAC_ERR_BAD_HANDLE);

  hfrac::Definition dry = quiet_def();
  ASSERT_EQ(hfrac_sim_def_set_str(&dry, "flow.scheme", "off"), HFRAC_OK);
  const Sim without(dry);
  EXPECT_EQ(hfrac_well_add(without, 75.0, 60.0, &index), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(without).find("flow.scheme"), std::string::npos) << last_error(without);
}

TEST(Well, RefusesAnIndexThatIsNotThere) {
  const Sim sim(quiet_def());
  hfrac_well_state well{};
  well.struct_size = sizeof well;
  const int64_t before = hash_of(sim), epoch = epoch_of(sim);
  for (const int32_t index : {-1, 1, INT32_MAX, INT32_MIN}) {
    EXPECT_EQ(hfrac_well_get(sim, index, &well), HFRAC_ERR_ARGUMENT);
    EXPECT_EQ(hfrac_well_set_pressure(sim, index, 30e6), HFRAC_ERR_ARGUMENT);
    EXPECT_EQ(hfrac_well_set_ramp(sim, index, 30e6, 1e6), HFRAC_ERR_ARGUMENT);
    EXPECT_EQ(hfrac_well_set_rate(sim, index, 0.0), HFRAC_ERR_ARGUMENT);
    EXPECT_EQ(last_error(sim).rfind("well " + std::to_string(index) + " is not there", 0), 0u)
        << last_error(sim);
    EXPECT_NE(last_error(sim).find("has 1 well"), std::string::npos) << last_error(sim);
  }
  EXPECT_EQ(hash_of(sim), before);
  EXPECT_EQ(epoch_of(sim), epoch);
}

TEST(Well, RefusesWhatIsNotFinite) {
  const Sim sim(quiet_def());
  const int64_t before = hash_of(sim), epoch = epoch_of(sim);
  for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_EQ(hfrac_well_set_pressure(sim, 0, value), HFRAC_ERR_ARGUMENT);
    EXPECT_NE(last_error(sim).find("pressure"), std::string::npos);
    EXPECT_EQ(hfrac_well_set_ramp(sim, 0, value, 1e6), HFRAC_ERR_ARGUMENT);
    EXPECT_EQ(hfrac_well_set_ramp(sim, 0, 30e6, value), HFRAC_ERR_ARGUMENT);
    EXPECT_NE(last_error(sim).find("per_step"), std::string::npos);
    EXPECT_EQ(hfrac_well_set_rate(sim, 0, value), HFRAC_ERR_ARGUMENT);
    EXPECT_NE(last_error(sim).find("rate"), std::string::npos);
  }
  EXPECT_EQ(hfrac_well_set_ramp(sim, 0, 30e6, -1e6), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(sim), "ramp_per_step = -1e6 is outside 0 to 1e12 Pa.");
  EXPECT_EQ(hfrac_well_set_ramp(sim, 0, 30e6, 0.0), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("per_step"), std::string::npos) << last_error(sim);
  EXPECT_EQ(hash_of(sim), before);
  EXPECT_EQ(epoch_of(sim), epoch);
}

// The limits of the option table hold for wells changed later too.
TEST(Well, RefusesWhatItsDefinitionWouldRefuse) {
  const Sim sim(quiet_def());
  EXPECT_EQ(hfrac_well_set_pressure(sim, 0, 2e12), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(sim), "pressure = 2e12 is outside -1e12 to 1e12 Pa.");
  EXPECT_EQ(hfrac_well_set_ramp(sim, 0, 2e12, 1e6), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_well_set_ramp(sim, 0, 30e6, 2e12), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_well_set_rate(sim, 0, 2e6), HFRAC_ERR_ARGUMENT);
}

// hfrac_sim_def_check refuses a rate without flow; so must this, or volumes are counted that are nowhere.
TEST(Well, RefusesARateWithoutFlow) {
  hfrac::Definition def = quiet_def();
  ASSERT_EQ(hfrac_sim_def_set_str(&def, "flow.scheme", "off"), HFRAC_OK);
  const Sim sim(def);
  EXPECT_EQ(hfrac_well_set_rate(sim, 0, 1e-3), HFRAC_ERR_ARGUMENT);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_EQ(balance_of(sim).fluid_error, 0.0);
}

}  // namespace well_test
