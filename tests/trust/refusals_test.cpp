// SPDX-License-Identifier: BSD-3-Clause
// What cannot be built, set or written is refused with a status and a sentence that names the way out; nothing is changed by it.
// Also models at the edge of what can be built, which must go on: servo-driven walls at rest, pores closed to the outside.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "../capi/sim_support.hpp"
#include "sealed_image.hpp"

namespace {

using namespace testing_capi;

void set(hfrac_sim_def& def, const char* key, const char* word) {
  ASSERT_EQ(hfrac_sim_def_set_str(&def, key, word), HFRAC_OK) << last_error();
}

TEST(Refusals, AModelThatCannotBeBuiltSaysWhatToChange) {
  struct Wrong {
    const char* words;
    std::function<void(hfrac_sim_def&)> change;
  };
  const auto seepage = [](hfrac_sim_def& def) {
    set(def, "initial.state", "seepage");
    def.flow_permeability = 1e-15;
  };
  const std::vector<Wrong> all = {
      {"needs flow",
       [&](auto& def) {
         seepage(def);
         set(def, "flow.scheme", "off");
       }},
      {"around one well",
       [&](auto& def) {
         seepage(def);
         def.well_count = 0;
       }},
      {"below zero absolute pressure",
       [&](auto& def) {
         seepage(def);
         def.initial_well_pressure = -1e9;
       }},
      {"permeability",
       [&](auto& def) {
         seepage(def);
         def.initial_seepage_time = 10.0;
         def.flow_permeability = 0.0;
       }},
      {"given_bond",
       [](auto& def) {
         static const int64_t bonds[2] = {0, 1};
         def.given_bonds = bonds;
         def.given_bond_count = 1;
       }},
      {"strength",
       [](auto& def) {
         def.bond_fracture_toughness = 1e6;
         def.bond_tensile_strength = 0.0;
       }},
      {"well[0]", [](auto& def) { def.wells[0].x = def.wells[0].y = 1.0; }},
  };
  for (const auto& [words, change] : all) {
    hfrac::Definition def = quiet_def(200);
    change(def);
    hfrac_sim* sim = nullptr;
    EXPECT_LT(hfrac_sim_create(&def, &sim), 0) << words;
    EXPECT_EQ(sim, nullptr);
    EXPECT_NE(last_error().find(words), std::string::npos) << last_error();
  }
}

TEST(Refusals, WhatASimulationCannotTakeChangesNothing) {
  hfrac::Definition def = quiet_def(200);
  set(def, "thermal.mode", "uniform");
  set(def, "thermal.outer", "held");
  const Sim uniform(def);
  set(def, "thermal.mode", "off");
  set(def, "flow.scheme", "off");
  const Sim dry(def);
  hfrac_grid grid{};
  grid.struct_size = sizeof grid;
  grid.nx = grid.ny = 2;
  grid.dx = grid.dy = 50.0;
  ASSERT_EQ(hfrac_set_grid(dry, &grid), HFRAC_OK) << last_error(dry);
  grid.origin[0] = 1e6;
  ASSERT_EQ(hfrac_set_grid(uniform, &grid), HFRAC_OK) << last_error(uniform);
  const int64_t warm_before = hash_of(uniform), dry_before = hash_of(dry);
  const std::vector<double> many(static_cast<std::size_t>(state_of(uniform).disc_count), 400.0);
  EXPECT_EQ(hfrac_set_disc_temperature(uniform, many.data(), static_cast<int64_t>(many.size())),
            HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(uniform).find("transport"), std::string::npos) << last_error(uniform);
  const double four[4] = {1e6, 1e6, 1e6, 1e6};
  EXPECT_EQ(hfrac_set_cell_pressure(dry, four, 4, nullptr, 0), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(dry).find("flow.scheme"), std::string::npos) << last_error(dry);
  EXPECT_LT(hfrac_write_grdecl(uniform, "/dev/null/never", 0, 0, 1, 0.0, 0.0), 0);
  EXPECT_NE(last_error(uniform).find("hfrac_set_grid"), std::string::npos) << last_error(uniform);
  EXPECT_EQ(hash_of(uniform), warm_before);
  EXPECT_EQ(hash_of(dry), dry_before);
}

// Walls that would have to pull run away from the rock, for ever.
TEST(Refusals, WallsAreNotAskedToPull) {
  hfrac::Definition def = quiet_def(200);
  set(def, "boundary.kind", "walls");
  set(def, "boundary.walls_after_equilibration", "servo");
  set(def, "stress.convention", "effective");
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 5e6;
  def.fluid_formation_pressure = 25e6;
  const Sim sim(def);
  const int64_t before = hash_of(sim);
  EXPECT_EQ(hfrac_set_far_field(sim, 5e6, -1e6), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("walls only push"), std::string::npos) << last_error(sim);
  EXPECT_EQ(hfrac_set_formation_pressure(sim, 31e6), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("walls only push"), std::string::npos) << last_error(sim);
  EXPECT_EQ(hash_of(sim), before);
  EXPECT_EQ(hfrac_set_formation_pressure(sim, 29e6), HFRAC_OK) << last_error(sim);
  def.stress_sigma_hmin = -1e6;
  hfrac_sim* none = nullptr;
  EXPECT_LT(hfrac_sim_create(&def, &none), 0);
  EXPECT_NE(last_error().find("walls only push"), std::string::npos) << last_error();
}

TEST(Refusals, AnImageWithSomethingAddedIsNotTaken) {
  const Sim sim(quiet_def(200));
  int64_t size = 0;
  ASSERT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
  std::vector<std::uint8_t> image(static_cast<std::size_t>(size));
  ASSERT_EQ(hfrac_state_save(sim, image.data(), size, &size), HFRAC_OK);
  const int64_t before = hash_of(sim);
  image.resize(image.size() + 8);
  testing_trust::seal(image);
  EXPECT_EQ(hfrac_state_restore(sim, image.data(), static_cast<int64_t>(image.size())), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("longer"), std::string::npos) << last_error(sim);
  EXPECT_EQ(hash_of(sim), before);
}

TEST(Refusals, AScheduleThatIsNoneIsNamed) {
  for (const auto& [entry, words] :
       {std::pair{"time = 1.0\nspeed = 2.0\n", "not a known key"},
        std::pair{"time = 1.0\n", "neither pressure nor rate"}, std::pair{"rate = 1.0\n", "has no time"}}) {
    std::string file = (std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : std::string("/tmp")) +
                       "/hfrac_refusal_XXXXXX";
    const int descriptor = ::mkstemp(file.data());
    ASSERT_GE(descriptor, 0);
    const std::string text =
        std::string("[[well]]\nradius = 3.0\npressure = 1e6\n[[well.schedule]]\n") + entry;
    ASSERT_EQ(::write(descriptor, text.data(), text.size()), static_cast<::ssize_t>(text.size()));
    ::close(descriptor);
    hfrac::Definition def = new_def();
    EXPECT_LT(hfrac_sim_def_load(&def, file.c_str()), 0) << entry;
    EXPECT_NE(last_error().find(words), std::string::npos) << last_error();
    ::unlink(file.c_str());
  }
}

// A well that has seeped before the treatment: pressures lie between the formation's and the well's, and fall outward.
TEST(OddModels, AWellThatSeepedStartsInBetween) {
  hfrac::Definition def = quiet_def(200);
  set(def, "initial.state", "seepage");
  def.initial_well_pressure = def.wells[0].pressure = 5e6;
  const Sim sim(def);
  const auto pressure = doubles(sim, HFRAC_DOMAIN_PRESSURE);
  const auto [least, most] = std::minmax_element(pressure.begin(), pressure.end());
  EXPECT_LE(*most, std::max(5e6, def.fluid_formation_pressure) * (1.0 + 1e-9));
  EXPECT_GE(*least, std::min(5e6, def.fluid_formation_pressure) * (1.0 - 1e-9));
  EXPECT_GT(*most - *least, 1e6);
  ASSERT_GE(hfrac_step(sim, 1), 0) << last_error(sim);
}

// A quasi-static model whose walls are driven by the far field, and whose pores nothing leaves.
TEST(OddModels, ServoWallsAndClosedPoresComeToRest) {
  hfrac::Definition def = quiet_def(200);
  set(def, "boundary.kind", "walls");
  set(def, "boundary.walls_after_equilibration", "servo");
  set(def, "solver.kind", "quasi-static");
  set(def, "stepping.mode", "coupled");
  set(def, "flow.outer", "closed");
  def.stepping_flow_step = 1e-2;
  const Sim sim(def);
  ASSERT_GE(hfrac_step(sim, 2), 0) << last_error(sim);
  EXPECT_EQ(balance_of(sim).leaked_volume, 0.0);
  EXPECT_LT(std::abs(balance_of(sim).fluid_error), 1e-9);
  for (const double x : doubles(sim, HFRAC_DISC_POSITION)) ASSERT_TRUE(std::isfinite(x));
}

}  // namespace
