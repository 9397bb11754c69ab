// SPDX-License-Identifier: BSD-3-Clause
// The definition struct, its sizes, the keyed setters, the option table.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "support.hpp"

namespace def_test {

using namespace testing_capi;

TEST(DefInit, GivesTheTablesDefaults) {
  const hfrac::Definition def = new_def();
  EXPECT_EQ(def.struct_size, static_cast<int32_t>(sizeof def));
  EXPECT_EQ(def.model_width, 100.0);
  EXPECT_EQ(def.packing_disc_count, 10000);
  EXPECT_EQ(def.contact_mode, 0);
  EXPECT_EQ(def.well_count, 0);
  EXPECT_EQ(def.progress, nullptr);
  EXPECT_EQ(def.given_discs, nullptr);
  EXPECT_STREQ(def.title, "");
}

TEST(DefInit, RefusesWrongSizes) {
  hfrac_sim_def def;
  EXPECT_EQ(hfrac_sim_def_init(nullptr, sizeof def), HFRAC_ERR_ARGUMENT);
  for (const int32_t size : {0, -8, 4, 7, 12, std::numeric_limits<int32_t>::max() - 7}) {
    EXPECT_EQ(hfrac_sim_def_init(&def, size), HFRAC_ERR_STRUCT_SIZE) << size;
  }
}

// A program of older headers cannot hold a newer option: it is told so instead of running without it.
TEST(DefInit, RefusesOptionsThatAnOlderCallerHasNoPlaceFor) {
  std::vector<unsigned char> memory(sizeof(hfrac_sim_def), 0);
  auto* def = reinterpret_cast<hfrac_sim_def*>(memory.data());
  constexpr std::size_t older = offsetof(hfrac_sim_def, rock_biot_coefficient);
  ASSERT_EQ(hfrac_sim_def_init(def, older), HFRAC_OK);
  EXPECT_EQ(hfrac_sim_def_set_f64(def, "rock.biot_coefficient", 1.0), HFRAC_OK);  // the default
  EXPECT_EQ(hfrac_sim_def_set_f64(def, "rock.biot_coefficient", 0.5), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_NE(last_error().find("rock.biot_coefficient has no place"), std::string::npos);
  const TemporaryFolder folder;
  const auto good = folder.write("[[well]]\nx = 3.0\ny = 4.0\nradius = 1.0\nrate = 1e-4\n");
  ASSERT_EQ(hfrac_sim_def_load(def, good.c_str()), HFRAC_OK) << last_error();
  const auto file = folder.write("[rock]\nporosity = 0.01\n");
  EXPECT_EQ(hfrac_sim_def_load(def, file.c_str()), HFRAC_ERR_STRUCT_SIZE);
  hfrac::Definition newer = new_def();
  newer.rock_porosity = 0.01;
  EXPECT_EQ(hfrac_sim_def_copy(&newer, def), HFRAC_ERR_STRUCT_SIZE);
  ASSERT_EQ(def->well_count, 1);  // what was refused left the lists as they were
  EXPECT_EQ(def->wells[0].x, 3.0);
  EXPECT_EQ(hfrac_sim_def_free(def), HFRAC_OK);
}

TEST(DefInit, FillsNoMoreThanAnOlderCallerHas) {
  std::vector<unsigned char> memory(sizeof(hfrac_sim_def), 0xEE);
  auto* def = reinterpret_cast<hfrac_sim_def*>(memory.data());
  constexpr std::size_t older = offsetof(hfrac_sim_def, title);
  ASSERT_EQ(hfrac_sim_def_init(def, older), HFRAC_OK);
  EXPECT_EQ(def->model_width, 100.0);
  EXPECT_EQ(memory[older], 0xEE);
  // The same for the setters, and what lies beyond is read as default.
  ASSERT_EQ(hfrac_sim_def_set_f64(def, "model.width", 50.0), HFRAC_OK);
  EXPECT_EQ(def->model_width, 50.0);
  EXPECT_EQ(memory[older], 0xEE);
  double count = -1.0;
  ASSERT_EQ(hfrac_sim_def_get_f64(def, "packing.brick_discs", &count), HFRAC_OK);
  EXPECT_EQ(count, 5000.0);
}

TEST(DefSize, NewerCallersAreAcceptedIfTheirTailIsZero) {
  struct Newer {
    hfrac_sim_def def;
    double more;
  } newer;
  ASSERT_EQ(hfrac_sim_def_init(&newer.def, sizeof newer), HFRAC_OK);
  EXPECT_EQ(newer.more, 0.0);
  EXPECT_EQ(newer.def.struct_size, static_cast<int32_t>(sizeof newer));
  EXPECT_EQ(hfrac_sim_def_set_f64(&newer.def, "model.width", 50.0), HFRAC_OK);
  newer.more = 1.0;
  EXPECT_EQ(hfrac_sim_def_set_f64(&newer.def, "model.width", 60.0), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_EQ(newer.def.model_width, 50.0);
  EXPECT_NE(last_error().find("newer header"), std::string::npos);
}

TEST(DefSize, StructsNeverInitialisedAreRefused) {
  hfrac_sim_def def;
  std::memset(&def, 0, sizeof def);
  double value = 0.0;
  int32_t needed = 0;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "model.width", 1.0), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_EQ(hfrac_sim_def_get_f64(&def, "model.width", &value), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_EQ(hfrac_sim_def_write(&def, nullptr, 0, &needed), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_EQ(hfrac_sim_def_load(&def, "/nowhere"), HFRAC_ERR_STRUCT_SIZE);
  std::memset(&def, 0xFF, sizeof def);
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_STRUCT_SIZE);
  ASSERT_EQ(hfrac_sim_def_init(&def, sizeof def), HFRAC_OK);
  def.struct_version = 1;  // when lists were arrays inside
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_NE(last_error().find("lists were arrays"), std::string::npos) << last_error();
  def.struct_version = 0;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_STRUCT_SIZE);
}

TEST(DefKeys, EveryOptionCanBeSetAndReadByItsKey) {
  hfrac::Definition def = new_def();
  int32_t count = 0;
  ASSERT_EQ(hfrac_option_count(&count), HFRAC_OK);
  ASSERT_GT(count, 40);
  for (int32_t i = 0; i < count; ++i) {
    hfrac_option_info info{};
    info.struct_size = sizeof info;
    ASSERT_EQ(hfrac_option_at(i, &info), HFRAC_OK);
    double value = -1.0;
    ASSERT_EQ(hfrac_sim_def_get_f64(&def, info.key, &value), HFRAC_OK) << info.key;
    EXPECT_EQ(value, info.default_value) << info.key;
    EXPECT_EQ(info.choices != nullptr, info.type == 2) << info.key;
    if (info.type == 0) {
      EXPECT_EQ(hfrac_sim_def_set_f64(&def, info.key, info.maximum), HFRAC_OK) << info.key;
      EXPECT_EQ(hfrac_sim_def_set_f64(&def, info.key, std::nextafter(info.maximum, HUGE_VAL)),
                HFRAC_ERR_ARGUMENT);
      EXPECT_EQ(hfrac_sim_def_set_f64(&def, info.key, std::nextafter(info.minimum, -HUGE_VAL)),
                HFRAC_ERR_ARGUMENT);
      EXPECT_EQ(hfrac_sim_def_set_f64(&def, info.key, std::nan("")), HFRAC_ERR_ARGUMENT);
      EXPECT_EQ(hfrac_sim_def_set_f64(&def, info.key, HUGE_VAL), HFRAC_ERR_ARGUMENT);
    } else {
      const auto largest = static_cast<int64_t>(info.maximum);
      EXPECT_EQ(hfrac_sim_def_set_i64(&def, info.key, largest), HFRAC_OK) << info.key;
      EXPECT_EQ(hfrac_sim_def_set_i64(&def, info.key, largest + 1), HFRAC_ERR_ARGUMENT) << info.key;
      EXPECT_EQ(hfrac_sim_def_set_i64(&def, info.key, INT64_MAX), HFRAC_ERR_ARGUMENT) << info.key;
      EXPECT_EQ(hfrac_sim_def_set_f64(&def, info.key, 1.0), HFRAC_ERR_ARGUMENT) << info.key;
    }
    ASSERT_EQ(hfrac_sim_def_get_f64(&def, info.key, &value), HFRAC_OK);
    EXPECT_EQ(value, info.maximum) << info.key;
  }
}

TEST(DefKeys, IntegersWillDoForReals) {
  hfrac::Definition def = new_def();
  ASSERT_EQ(hfrac_sim_def_set_i64(&def, "model.width", 70), HFRAC_OK);
  EXPECT_EQ(def.model_width, 70.0);
}

TEST(DefKeys, ChoicesAreSetByWord) {
  hfrac::Definition def = new_def();
  ASSERT_EQ(hfrac_sim_def_set_str(&def, "flow.scheme", "explicit"), HFRAC_OK);
  EXPECT_EQ(def.flow_scheme, 1);
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "flow.scheme", "implict"), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(), "flow.scheme = \"implict\" is not one of implicit, explicit or off.");
  EXPECT_EQ(hfrac_sim_def_set_i64(&def, "flow.scheme", 3), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(), "flow.scheme = 3 is not one of 0 (implicit), 1 (explicit) or 2 (off).");
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "model.width", "wide"), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(def.flow_scheme, 1);
}

TEST(DefKeys, UnknownKeysNameTheNearest) {
  hfrac::Definition def = new_def();
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "bond.tensile_strengh", 1.0), HFRAC_ERR_UNKNOWN_KEY);
  EXPECT_EQ(last_error(), "bond.tensile_strengh is not a known key; did you mean bond.tensile_strength?");
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "packing.density", 1.0), HFRAC_ERR_UNKNOWN_KEY);
  EXPECT_EQ(last_error(), "packing.density is not a known key; did you mean disc.density?");
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "qqq", 1.0), HFRAC_ERR_UNKNOWN_KEY);
  EXPECT_EQ(last_error(), "qqq is not a known key.");
  for (const char* key :
       {"", "well[", "well[0]", "well[-1].x", "well[0].", "well[99999999999999999999].x", "well.x", "."}) {
    EXPECT_EQ(hfrac_sim_def_set_f64(&def, key, 1.0), HFRAC_ERR_UNKNOWN_KEY) << key;
  }
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, std::string(100000, 'a').c_str(), 1.0), HFRAC_ERR_UNKNOWN_KEY);
  double value = 0.0;
  EXPECT_EQ(hfrac_sim_def_get_f64(&def, "well[0].radus", &value), HFRAC_ERR_UNKNOWN_KEY);
  EXPECT_EQ(last_error(), "well.radus is not a known key; did you mean well.radius?");
}

TEST(DefKeys, WellsAreAddedInOrder) {
  hfrac::Definition def = new_def();
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "well[1].x", 50.0), HFRAC_ERR_ARGUMENT);
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "well[0].x", 50.0), HFRAC_OK);
  EXPECT_EQ(def.well_count, 1);
  ASSERT_EQ(hfrac_sim_def_set_str(&def, "well[0].control", "rate"), HFRAC_OK);
  EXPECT_EQ(def.wells[0].control, HFRAC_WELL_RATE);
  EXPECT_EQ(hfrac_sim_def_set_i64(&def, "well[0].control", 3), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "well[0].radius", -1.0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(), "well[0].radius = -1 is outside 1e-6 to 1e6 m.");
  double value = 0.0;
  ASSERT_EQ(hfrac_sim_def_get_f64(&def, "well[0].x", &value), HFRAC_OK);
  EXPECT_EQ(value, 50.0);
  EXPECT_EQ(hfrac_sim_def_get_f64(&def, "well[1].x", &value), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_set_i64(&def, "well_count", -1), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(), "well_count = -1 is outside 0 to 100000000.");
  EXPECT_EQ(hfrac_sim_def_set_i64(&def, "well_count", 8), HFRAC_OK);
  EXPECT_EQ(def.wells[0].x, 50.0);
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "well[9].x", 1.0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(), "well[9] is not there: well_count is 8; wells are added in order.");
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "well[8].x", 1.0), HFRAC_OK);
  EXPECT_EQ(def.well_count, 9);
}

TEST(DefKeys, TitlesMustFit) {
  hfrac::Definition def = new_def();
  ASSERT_EQ(hfrac_sim_def_set_str(&def, "title", std::string(127, 't').c_str()), HFRAC_OK);
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "title", std::string(128, 't').c_str()), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "title", "\xFF"), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(std::string(def.title), std::string(127, 't'));
  std::memset(def.title, 't', sizeof def.title);
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_ARGUMENT);
}

TEST(DefKeys, SayHowLargeThePackingsDiscsAre) {
  hfrac::Definition def = new_def();
  double fine = 0.0, coarsest = 0.0, same = 0.0;
  ASSERT_EQ(hfrac_sim_def_disc_radii(&def, &same, &coarsest), HFRAC_OK);
  EXPECT_EQ(same, coarsest);
  def.packing_coarsening = 4.0;
  ASSERT_EQ(hfrac_sim_def_disc_radii(&def, &fine, &coarsest), HFRAC_OK);
  EXPECT_LT(fine, same);
  EXPECT_NEAR(coarsest / fine, 4.0, 1e-12);
  def.packing_radius_growth = 0.01;  // nowhere four times as coarse then
  ASSERT_EQ(hfrac_sim_def_disc_radii(&def, &fine, &coarsest), HFRAC_OK);
  EXPECT_LT(coarsest / fine, 4.0);
  EXPECT_EQ(hfrac_sim_def_disc_radii(&def, nullptr, &coarsest), HFRAC_ERR_ARGUMENT);
}

TEST(DefKeys, NullIsRefused) {
  hfrac::Definition def = new_def();
  double value = 0.0;
  int32_t needed = 0;
  EXPECT_EQ(hfrac_sim_def_set_f64(nullptr, "model.width", 1.0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, nullptr, 1.0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_set_i64(nullptr, "model.seed", 1), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_set_i64(&def, nullptr, 1), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_set_str(nullptr, "title", ""), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_set_str(&def, nullptr, ""), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "title", nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_get_f64(nullptr, "model.width", &value), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_get_f64(&def, nullptr, &value), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_get_f64(&def, "model.width", nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_load(nullptr, "x"), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_load(&def, nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_write(nullptr, nullptr, 0, &needed), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_check(nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_option_count(nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_option_at(0, nullptr), HFRAC_ERR_ARGUMENT);
}

TEST(OptionTable, IndexAndSizeAreChecked) {
  hfrac_option_info info{};
  EXPECT_EQ(hfrac_option_at(0, &info), HFRAC_ERR_STRUCT_SIZE);
  info.struct_size = sizeof info;
  EXPECT_EQ(hfrac_option_at(-1, &info), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_option_at(100000, &info), HFRAC_ERR_ARGUMENT);
  ASSERT_EQ(hfrac_option_at(0, &info), HFRAC_OK);
  EXPECT_STREQ(info.key, "model.width");
  EXPECT_STREQ(info.unit, "m");
  EXPECT_EQ(info.struct_size, static_cast<int32_t>(sizeof info));
}

}  // namespace def_test
