// SPDX-License-Identifier: BSD-3-Clause
// Case files that are right: what they set, what they leave, and that what is written reads back the same.
#include <gtest/gtest.h>

#include <cstring>

#include "support.hpp"

namespace case_file_test {

using namespace testing_capi;

TEST(CaseFile, SetsWhatItNamesAndLeavesTheRest) {
  const TemporaryFolder folder;
  const std::string path = folder.write(
      "title = \"two wells\"\n"
      "[model]\nwidth = 60   # an integer will do\n[stress]\nconvention = \"effective\"\n"
      "[bond]\ntensile_strength = 30e6\n"
      "[packing]\ndisc_count = 2_000\n"
      "[[well]]\nradius = 3.0\npressure = 45e6\nx = 20.0\n"
      "[[well]]\nradius = 4.0\nrate = 1e-4\n");
  hfrac::Definition def = new_def();
  def.disc_density = 2500.0;
  ASSERT_EQ(hfrac_sim_def_load(&def, path.c_str()), HFRAC_OK) << last_error();
  EXPECT_STREQ(def.title, "two wells");
  EXPECT_EQ(def.model_width, 60.0);
  EXPECT_EQ(def.stress_convention, 1);
  EXPECT_EQ(def.bond_tensile_strength, 30e6);
  EXPECT_EQ(def.packing_disc_count, 2000);
  EXPECT_EQ(def.disc_density, 2500.0);
  ASSERT_EQ(def.well_count, 2);
  EXPECT_EQ(def.wells[0].x, 20.0);
  EXPECT_EQ(def.wells[0].y, 50.0);
  EXPECT_EQ(def.wells[0].control, HFRAC_WELL_PRESSURE);
  EXPECT_EQ(def.wells[1].x, 30.0);
  EXPECT_EQ(def.wells[1].control, HFRAC_WELL_RATE);
}

TEST(CaseFile, WellsReplaceThoseSetBefore) {
  const TemporaryFolder folder;
  hfrac::Definition def = sound_def();
  ASSERT_EQ(hfrac_sim_def_load(&def, folder.write("[model]\nwidth = 80.0\n").c_str()), HFRAC_OK)
      << last_error();
  EXPECT_EQ(def.well_count, 1);
  EXPECT_EQ(def.wells[0].pressure, 45e6);
  ASSERT_EQ(hfrac_sim_def_load(&def, folder.write("well = []\n").c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(def.well_count, 0);
}

TEST(CaseFile, ControlFollowsFromWhatIsGiven) {
  const TemporaryFolder folder;
  hfrac::Definition def = new_def();
  const std::string path = folder.write("[[well]]\nradius = 3\npressure = 45e6\nramp_per_step = 1e6\n");
  ASSERT_EQ(hfrac_sim_def_load(&def, path.c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(def.wells[0].control, HFRAC_WELL_RAMP);
}

TEST(CaseFile, AnEmptyFileChangesNothing) {
  const TemporaryFolder folder;
  hfrac::Definition def = sound_def(), before = def;
  ASSERT_EQ(hfrac_sim_def_load(&def, folder.write("").c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(written(def), written(before));
  ASSERT_EQ(hfrac_sim_def_load(&def, folder.write("\xEF\xBB\xBF# only a comment\r\n").c_str()), HFRAC_OK)
      << last_error();
  EXPECT_EQ(written(def), written(before));
}

TEST(CaseFile, WrittenDefinitionsReadBackBitForBit) {
  const TemporaryFolder folder;
  hfrac::Definition def = sound_def();
  def.model_width = 100.0 / 3.0;
  def.flow_permeability = 5.5270000000000001e-15;
  def.packing_residual = 0.01 + 1e-17;
  def.stress_sigma_hmin = 0x1.fffffffffffffp+24;
  def.model_seed = 9007199254740991;
  def.flow_scheme = 1;
  def.contact_mode = 1;
  hfrac_sim_def_set_i64(&def, "well_count", 2);
  def.wells[1] = {1.0 / 3.0, 0.1,  5e-324 + 1e-6, -0.0,      1e5,  -1e-300, HFRAC_WELL_RAMP, 1e-9,
                  8.0,       0.01, 0.8,           1e6 / 3.0, 20.0, 2000.0,  998.1,           3,
                  1,         2.5,  -1.5,          8.55};
  std::strcpy(def.title, "quotes \" and \\, a tab \t, umlauts \xC3\xA4, a bell \x07");
  const std::string text = written(def);
  ASSERT_FALSE(text.empty()) << last_error();
  hfrac::Definition read = new_def();
  ASSERT_EQ(hfrac_sim_def_load(&read, folder.write(text).c_str()), HFRAC_OK) << last_error() << "\n" << text;
  EXPECT_EQ(
      std::memcmp(&def.model_width, &read.model_width, sizeof def - offsetof(hfrac_sim_def, model_width)), 0)
      << text;
  EXPECT_EQ(std::memcmp(def.wells, read.wells, 2 * sizeof *def.wells), 0) << text;
  EXPECT_EQ(written(read), text);
}

TEST(CaseFile, NoWellsReadBackAsNoWells) {
  const TemporaryFolder folder;
  hfrac::Definition none = new_def(), one = sound_def();
  ASSERT_EQ(hfrac_sim_def_load(&one, folder.write(written(none)).c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(one.well_count, 0);
}

TEST(CaseFile, ASchedulesFluidIsReadAndWritten) {
  const TemporaryFolder folder;
  hfrac::Definition def = new_def();
  const std::string file = folder.write(
      "fluid.second_viscosity = 0.5\n[[well]]\nradius = 10.0\nrate = 0.01\nfluid = "
      "\"second\"\n[[well.schedule]]\ntime = 60\nrate = "
      "0.01\nfluid = \"first\"\n[[well.schedule]]\ntime = 90\nrate = 0\n");
  ASSERT_EQ(hfrac_sim_def_load(&def, file.c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(def.fluid_second_viscosity, 0.5);
  EXPECT_EQ(def.wells[0].fluid, 1);
  ASSERT_EQ(def.schedule_count, 2);
  EXPECT_EQ(def.schedule[0].fluid, 1);
  EXPECT_EQ(def.schedule[1].fluid, 0);
  const std::string text = written(def);
  EXPECT_NE(text.find("fluid = \"first\"\n"), std::string::npos) << text;
  hfrac::Definition read = new_def();
  ASSERT_EQ(hfrac_sim_def_load(&read, folder.write(text).c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(std::memcmp(def.schedule, read.schedule, 2 * sizeof *def.schedule), 0);
  EXPECT_EQ(written(read), text);
}

TEST(CaseFile, WhatCannotBeReadIsNotWritten) {
  hfrac::Definition def = sound_def();
  def.packing_porosity = 0.9;
  int32_t needed = 0;
  EXPECT_EQ(hfrac_sim_def_write(&def, nullptr, 0, &needed), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(), "packing.porosity = 0.9 is outside 0.08 to 0.2.");
}

}  // namespace case_file_test
