// SPDX-License-Identifier: BSD-3-Clause
// Rock that falls apart is an error of its own kind, and no result.
#include <gtest/gtest.h>

#include <string>

#include "sim_support.hpp"
#include "support.hpp"

namespace collapse_test {

using namespace testing_capi;

// A hole as wide as a few discs, under a pressure that throws those around it out.
hfrac::Definition torn(int64_t discs, double radius, double pressure) {
  hfrac::Definition def;
  def.packing_disc_count = discs;
  hfrac_sim_def_set_i64(&def, "well_count", 1);
  def.wells[0].radius = radius;
  def.wells[0].pressure = pressure;
  return def;
}

void expect_words(const std::string& text, std::initializer_list<const char*> words) {
  for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << ": " << text;
}

TEST(Collapse, OfAStepIsRefusedAndTheStateBeforeItStands) {
  for (const int64_t mode : {0, 1}) {
    for (hfrac::Definition def : {torn(60, 22.0, 30e6), torn(300, 15.0, 60e6)}) {
      def.stepping_mode = mode;
      const Sim sim(def);
      int32_t status = HFRAC_OK;
      int64_t hash = 0;
      for (int k = 0; k < 5 && status >= 0; ++k) {
        hash = hash_of(sim);
        status = hfrac_step(sim, 1);
      }
      ASSERT_EQ(status, HFRAC_ERR_COLLAPSED) << mode;
      const auto state = state_of(sim);
      expect_words(last_error(sim),
                   {("fell apart in step " + std::to_string(state.step + 1)).c_str(), ": disc ",
                    " m, moved by ", "more than its diameter of ", "Use a lower pressure or rate"});
      EXPECT_EQ(hash_of(sim), hash);
      EXPECT_LT(state.tip_distance, 100.0);
      // The simulation can be used on: with its well as before, rock that bears that stands.
      if (def.packing_disc_count < 300) continue;
      ASSERT_EQ(hfrac_well_set_pressure(sim, 0, 25e6), HFRAC_OK);
      if (state.step > 0) continue;
      EXPECT_GE(hfrac_step(sim, 1), HFRAC_OK) << last_error(sim);
    }
  }
}

// Rock a hundred times too soft and never too weak: an equilibrium is found, and it is far away.
TEST(Collapse, OfACoupledStepIsRefusedToo) {
  hfrac::Definition def = torn(300, 15.0, 120e6);
  def.stepping_mode = 2;
  def.solver_kind = 1;
  def.contact_normal_stiffness = def.bond_normal_stiffness = 3e8;
  def.contact_shear_stiffness = def.bond_shear_stiffness = 1e8;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  const Sim sim(def);
  const int64_t hash = hash_of(sim);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_ERR_COLLAPSED) << last_error(sim);
  expect_words(last_error(sim), {"fell apart in step 1: disc ", "more than its diameter of "});
  EXPECT_EQ(hash_of(sim), hash);
  ASSERT_EQ(hfrac_well_set_pressure(sim, 0, 25e6), HFRAC_OK);
  EXPECT_GE(hfrac_step(sim, 1), HFRAC_OK) << last_error(sim);
}

TEST(Collapse, OfTheInitialEquilibrationIsRefusedUnlessAllowed) {
  hfrac::Definition def;
  def.packing_disc_count = 600;
  def.stress_sigma_Hmax = 60e6;
  def.stress_sigma_hmin = 30e6;
  def.bond_tensile_strength = def.bond_shear_strength = 4e6;
  hfrac_sim* none = nullptr;
  ASSERT_EQ(hfrac_sim_create(&def, &none), HFRAC_ERR_COLLAPSED);
  EXPECT_EQ(none, nullptr);
  expect_words(last_error(), {"does not bear the far field", "at most 1 % may (initial.broken_fraction)",
                              "raise bond.tensile_strength"});
  // All bonds may break: then it is rest that is wanted.
  def.initial_broken_fraction = 1.0;
  def.stepping_max_cycles = 1000;
  ASSERT_EQ(hfrac_sim_create(&def, &none), HFRAC_ERR_COLLAPSED);
  expect_words(last_error(), {"does not come to rest", "the unbalanced-force ratio stayed at ", "above 0.1"});
  def.initial_broken_fraction = 1.5;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_ARGUMENT);
}

TEST(Collapse, HasItsOwnText) {
  char text[256];
  ASSERT_EQ(hfrac_status_text(HFRAC_ERR_COLLAPSED, text, sizeof text, nullptr), HFRAC_OK);
  expect_words(text, {"the rock fell apart"});
}

}  // namespace collapse_test
