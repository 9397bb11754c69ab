// SPDX-License-Identifier: BSD-3-Clause
// An option or a field under the name it had before: refused everywhere, with the name it has now.
#include <gtest/gtest.h>

#include <string>

#include "support.hpp"

namespace renamed_options_test {

using namespace testing_capi;

struct Renamed {
  const char *before, *now, *case_file;
};
const Renamed all[] = {
    {"model.reading", "stress.convention", "[model]\nreading = \"paper\"\n"},
    {"stress.sigma_H", "stress.sigma_Hmax", "[stress]\nsigma_H = 1e6\n"},
    {"stress.sigma_h", "stress.sigma_hmin", "[stress]\nsigma_h = 1e6\n"},
    {"stepping.substeps", "stepping.steps", "[stepping]\nsubsteps = 3\n"},
    {"boundary.walls_after_setup", "boundary.walls_after_equilibration",
     "[boundary]\nwalls_after_setup = \"servo\"\n"},
};

TEST(RenamedOptions, AreRefusedInCaseFilesWithTheNewName) {
  const TemporaryFolder folder;
  for (const auto& one : all) {
    hfrac::Definition def = new_def();
    const std::string path = folder.write(one.case_file);
    EXPECT_EQ(hfrac_sim_def_load(&def, path.c_str()), HFRAC_ERR_CASE_FILE) << one.before;
    EXPECT_NE(last_error().find(":2: " + std::string(one.before) + " is now called " + one.now),
              std::string::npos)
        << last_error();
  }
}

TEST(RenamedOptions, AreRefusedByKeyWithTheNewName) {
  for (const auto& one : all) {
    hfrac::Definition def = new_def();
    double real = 0.0;
    const std::string told = std::string(one.before) + " is now called " + one.now;
    EXPECT_EQ(hfrac_sim_def_set_f64(&def, one.before, 1.0), HFRAC_ERR_UNKNOWN_KEY);
    EXPECT_EQ(last_error().rfind(told, 0), 0u) << last_error();
    EXPECT_EQ(hfrac_sim_def_set_str(&def, one.before, "paper"), HFRAC_ERR_UNKNOWN_KEY);
    EXPECT_EQ(last_error().rfind(told, 0), 0u) << last_error();
    EXPECT_EQ(hfrac_sim_def_get_f64(&def, one.before, &real), HFRAC_ERR_UNKNOWN_KEY);
    EXPECT_EQ(last_error().rfind(told, 0), 0u) << last_error();
  }
}

TEST(RenamedOptions, TheNewNamesAreKnown) {
  for (const auto& one : all) {
    hfrac::Definition def = new_def();
    double value = 0.0;
    EXPECT_EQ(hfrac_sim_def_get_f64(&def, one.now, &value), HFRAC_OK) << last_error();
  }
}

TEST(RenamedOptions, SoAreFields) {
  int32_t field = -1;
  EXPECT_EQ(hfrac_field_find("domain.filled", &field), HFRAC_ERR_UNKNOWN_KEY);
  EXPECT_EQ(last_error(), "domain.filled is now called domain.saturation.");
  EXPECT_EQ(hfrac_field_find("domain.saturation", &field), HFRAC_OK);
  EXPECT_EQ(field, HFRAC_DOMAIN_SATURATION);
}

TEST(RenamedOptions, NewWordsOfAChoiceAreNamed) {
  hfrac::Definition def = new_def();
  EXPECT_NE(hfrac_sim_def_set_str(&def, "model.reading", "sound"), HFRAC_OK);
  EXPECT_EQ(last_error(),
            "model.reading is now called stress.convention, and \"sound\" is \"total\" and \"paper\" is "
            "\"effective\".");
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "stress.convention", "effective"), HFRAC_OK);
  EXPECT_EQ(def.stress_convention, 1);
}

}  // namespace renamed_options_test
