// SPDX-License-Identifier: BSD-3-Clause
// What hfrac_sim_def_check refuses, and that its texts name the values and the fix.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "../joint_def.hpp"
#include "support.hpp"

namespace check_test {

using namespace testing_capi;

struct Contradiction {
  const char* name;
  std::function<void(hfrac_sim_def&)> make;
  int32_t status;
  std::vector<std::string> told;
};

// Instead of the bytes of the struct, which differ from run to run.
void PrintTo(const Contradiction& c, std::ostream* out) {
  *out << c.name;
}

void second_well(hfrac_sim_def& def, double x) {
  hfrac_sim_def_set_i64(&def, "well_count", 2);
  def.wells[1] = def.wells[0];
  def.wells[1].x = x;
}

const Contradiction contradictions[] = {
    {"StressesSwapped",
     [](auto& d) { d.stress_sigma_hmin = 50e6; },
     HFRAC_ERR_MODEL,
     {"stress.sigma_hmin = 5e7 Pa", "stress.sigma_Hmax = 4e7 Pa", "swap"}},
    {"EffectiveStressNegative",
     [](auto& d) { d.fluid_formation_pressure = 31e6; },
     HFRAC_ERR_MODEL,
     {"stress.sigma_hmin = 3e7 Pa", "fluid.formation_pressure = 3.1e7 Pa", "effective"}},
    {"NotANumber",
     [](auto& d) { d.disc_density = std::nan(""); },
     HFRAC_ERR_ARGUMENT,
     {"disc.density = nan", "1 to 1e5 kg/m3"}},
    {"Infinite",
     [](auto& d) { d.stress_sigma_Hmax = HUGE_VAL; },
     HFRAC_ERR_ARGUMENT,
     {"stress.sigma_Hmax = inf", "finite"}},
    {"OutOfRange",
     [](auto& d) { d.packing_porosity = 0.9; },
     HFRAC_ERR_ARGUMENT,
     {"packing.porosity = 0.9 is outside 0.08 to 0.2."}},
    {"IntegerOutOfRange",
     [](auto& d) { d.model_seed = -1; },
     HFRAC_ERR_ARGUMENT,
     {"model.seed = -1 is outside 0 to 9007199254740991."}},
    {"ChoiceOutOfRange",
     [](auto& d) { d.contact_mode = 2; },
     HFRAC_ERR_ARGUMENT,
     {"contact.mode = 2", "0 (parallel) or 1 (after-break)"}},
    {"TooManyDiscs",
     [](auto& d) { d.packing_disc_count = INT64_MAX; },
     HFRAC_ERR_ARGUMENT,
     {"packing.disc_count = 9223372036854775807", "20 to 100000000"}},
    {"ModelTooThin",
     [](auto& d) {
       d.model_height = 1.0;
       d.packing_disc_count = 100;
       d.well_count = 0;
     },
     HFRAC_ERR_MODEL,
     {"smaller model side of 1 m"}},
    {"WellOutside",
     [](auto& d) { d.wells[0].x = 150.0; },
     HFRAC_ERR_MODEL,
     {"well[0] at (150, 50) m", "inside the model"}},
    {"WellAcrossTheEdge", [](auto& d) { d.wells[0].y = 95.0; }, HFRAC_ERR_MODEL, {"well[0] at (50, 95) m"}},
    {"WellPlaceNotANumber",
     [](auto& d) { d.wells[0].y = std::nan(""); },
     HFRAC_ERR_ARGUMENT,
     {"well[0].y = nan"}},
    {"WellRadiusNegative",
     [](auto& d) { d.wells[0].radius = -6.0; },
     HFRAC_ERR_ARGUMENT,
     {"well[0].radius = -6 is outside"}},
    {"WellRadiusZero",
     [](auto& d) { d.wells[0].radius = 0.0; },
     HFRAC_ERR_ARGUMENT,
     {"well[0].radius = 0 is outside"}},
    {"WellTooLarge",
     [](auto& d) { d.wells[0].radius = 26.0; },
     HFRAC_ERR_MODEL,
     {"well[0].radius = 26 m", "25 m"}},
    {"WellTooSmall",
     [](auto& d) { d.wells[0].radius = 0.9; },
     HFRAC_ERR_MODEL,
     {"well[0].radius = 0.9 m", "disc_count"}},
    {"WellsOverlap",
     [](auto& d) { second_well(d, 61.0); },
     HFRAC_ERR_MODEL,
     {"well[0] and well[1] overlap", "11 m apart"}},
    {"WellControlUnknown",
     [](auto& d) { d.wells[0].control = 3; },
     HFRAC_ERR_ARGUMENT,
     {"well[0].control = 3", "2 (rate)"}},
    {"RampWithoutRise",
     [](auto& d) { d.wells[0].control = HFRAC_WELL_RAMP; },
     HFRAC_ERR_MODEL,
     {"well[0].ramp_per_step = 0 Pa"}},
    {"RateWithoutFlow",
     [](auto& d) {
       d.wells[0].control = HFRAC_WELL_RATE;
       d.flow_scheme = 2;
     },
     HFRAC_ERR_MODEL,
     {"flow.scheme = \"off\""}},
    {"PressureBelowVacuum",
     [](auto& d) { d.wells[0].pressure = -1.0; },
     HFRAC_ERR_MODEL,
     {"well[0].pressure = -1 Pa", "absolute"}},
    {"MoreWellsThanTheListHas",
     [](auto& d) { d.well_count = 9; },
     HFRAC_ERR_ARGUMENT,
     {"well_count = 9, but the library's list has 1;"}},
    {"WellsOfNowhere",
     [](auto& d) { d.wells = nullptr; },
     HFRAC_ERR_ARGUMENT,
     {"well_count = 1, but there are no items; point wells to"}},
    {"JointsWithoutASize",
     [](auto& d) {
       static hfrac_joint_def joint = joint_def(10.0, 10.0, 20.0, 20.0, 1.0, 1.0, -1.0, HFRAC_JOINT_BONDED);
       d.joints = &joint;
       d.joint_count = 1;
     },
     HFRAC_ERR_STRUCT_SIZE,
     {"joint_size = 0 cannot be the size of an item; set it to sizeof(hfrac_joint_def)."}},
    {"NegativeWells", [](auto& d) { d.well_count = -1; }, HFRAC_ERR_ARGUMENT, {"well_count = -1"}},
    {"RockWithoutStiffness",
     [](auto& d) {
       d.contact_mode = 1;
       d.bond_normal_stiffness = 0.0;
     },
     HFRAC_ERR_MODEL,
     {"bond.normal_stiffness"}},
    {"ApertureAboveItsLimit",
     [](auto& d) { d.flow_zero_stress_aperture = 0.1; },
     HFRAC_ERR_MODEL,
     {"flow.aperture_limit"}},
    {"DiscsWithoutCount",
     [](auto& d) {
       static const double disc[3] = {1, 1, 1};
       d.given_discs = disc;
     },
     HFRAC_ERR_ARGUMENT,
     {"given_disc_count"}},
    {"CountWithoutDiscs", [](auto& d) { d.given_disc_count = 100; }, HFRAC_ERR_ARGUMENT, {"given_discs"}},
    {"NegativeDiscCount",
     [](auto& d) { d.given_disc_count = -1; },
     HFRAC_ERR_ARGUMENT,
     {"given_disc_count = -1"}},
};

class Refused : public testing::TestWithParam<Contradiction> {};

TEST_P(Refused, WithTheValueAndTheFix) {
  hfrac::Definition def = sound_def();
  GetParam().make(def);
  EXPECT_EQ(hfrac_sim_def_check(&def), GetParam().status);
  for (const auto& part : GetParam().told)
    EXPECT_NE(last_error().find(part), std::string::npos) << last_error();
}
INSTANTIATE_TEST_SUITE_P(Check, Refused, testing::ValuesIn(contradictions),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Check, AcceptsWhatCanBeBuilt) {
  hfrac::Definition def = sound_def();
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
  second_well(def, 75.0);
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
  def.well_count = 0;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
}

TEST(Check, EffectiveConventionTakesEffectiveStresses) {
  hfrac::Definition def = sound_def();
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 0.0;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_MODEL);
  def.stress_convention = 1;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
}

std::vector<double> lattice(double radius) {
  std::vector<double> discs;
  for (int i = 0; i < 400; ++i)
    discs.insert(discs.end(), {2.5 + 5.0 * (i % 20), 2.5 + 5.0 * (i / 20), radius});
  return discs;
}

TEST(Check, GivenDiscsAreLookedAt) {
  std::vector<double> discs = lattice(2.5);
  hfrac::Definition def = sound_def();
  def.given_discs = discs.data();
  def.given_disc_count = 400;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
  for (const double wrong : {std::nan(""), -1.0, HUGE_VAL}) {
    std::vector<double> broken = discs;
    broken[3 * 7 + 2] = wrong;
    def.given_discs = broken.data();
    EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_MODEL);
    EXPECT_NE(last_error().find("given_discs[7]"), std::string::npos) << last_error();
  }
  std::vector<double> outside = discs;
  outside[3 * 9] = 101.0;
  def.given_discs = outside.data();
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_MODEL);
  def.given_discs = discs.data();
  def.given_disc_count = 10;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_MODEL);
  def.given_disc_count = 400;
  def.wells[0].radius = 4.0;  // below two of these discs' radii
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_MODEL);
}

}  // namespace check_test
