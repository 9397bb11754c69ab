// SPDX-License-Identifier: BSD-3-Clause
// Options by key, read and listed in all their types; names that are nearly right.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <string>

#include "sim_support.hpp"

namespace keyed_test {

using namespace testing_capi;

std::string text_of(const hfrac_sim_def& def, const char* key) {
  int32_t needed = 0;
  EXPECT_EQ(hfrac_sim_def_get_str(&def, key, nullptr, 0, &needed), HFRAC_OK) << key << ": " << last_error();
  std::string text(static_cast<std::size_t>(needed), '\0');
  EXPECT_EQ(hfrac_sim_def_get_str(&def, key, text.data(), needed, nullptr), HFRAC_OK);
  text.pop_back();
  return text;
}
int64_t integer_of(const hfrac_sim_def& def, const char* key) {
  int64_t value = -77;
  EXPECT_EQ(hfrac_sim_def_get_i64(&def, key, &value), HFRAC_OK) << key << ": " << last_error();
  return value;
}

TEST(KeyedGet, GivesWhatWasSetInEveryType) {
  hfrac::Definition def = cracking_def();
  def.model_seed = 9007199254740991;
  def.bond_tensile_strength = 0.1 + 0.2;
  def.wells[0].control = HFRAC_WELL_RATE;
  std::strcpy(def.title, "R\xc3\xb6hre");
  EXPECT_EQ(integer_of(def, "model.seed"), 9007199254740991);
  EXPECT_EQ(integer_of(def, "boundary.kind"), 1);
  EXPECT_EQ(integer_of(def, "well[0].control"), HFRAC_WELL_RATE);
  EXPECT_EQ(integer_of(def, "well_count"), 1);
  EXPECT_EQ(text_of(def, "model.seed"), "9007199254740991");
  EXPECT_EQ(text_of(def, "boundary.kind"), "walls");
  EXPECT_EQ(text_of(def, "well[0].control"), "rate");
  EXPECT_EQ(text_of(def, "well_count"), "1");
  EXPECT_EQ(text_of(def, "title"), "R\xc3\xb6hre");
  EXPECT_EQ(std::stod(text_of(def, "bond.tensile_strength")), 0.1 + 0.2);
  EXPECT_EQ(std::stod(text_of(def, "well[0].radius")), 10.0);
}

// Every option, read as text and set from that text in its own type, comes back.
TEST(KeyedGet, TextGivesTheValueBack) {
  const hfrac::Definition def = cracking_def();
  hfrac::Definition back = new_def();
  int32_t count = 0;
  ASSERT_EQ(hfrac_option_count(&count), HFRAC_OK);
  for (int32_t i = 0; i < count; ++i) {
    const auto info = read_struct<hfrac_option_info>([&](auto* to) { return hfrac_option_at(i, to); });
    const std::string text = text_of(def, info.key);
    const int32_t status = info.type == 2   ? hfrac_sim_def_set_str(&back, info.key, text.c_str())
                           : info.type == 1 ? hfrac_sim_def_set_i64(&back, info.key, std::stoll(text))
                                            : hfrac_sim_def_set_f64(&back, info.key, std::stod(text));
    EXPECT_EQ(status, HFRAC_OK) << info.key << " = " << text << ": " << last_error();
    double was = 0.0, is = 1.0;
    EXPECT_EQ(hfrac_sim_def_get_f64(&def, info.key, &was), HFRAC_OK);
    EXPECT_EQ(hfrac_sim_def_get_f64(&back, info.key, &is), HFRAC_OK);
    EXPECT_EQ(was, is) << info.key;
  }
}

TEST(KeyedGet, RefusesWhatItCannotGive) {
  const hfrac::Definition def = cracking_def();
  int64_t value = -77;
  char text[8];
  EXPECT_EQ(hfrac_sim_def_get_i64(&def, "bond.tensile_strength", &value), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error().find("hfrac_sim_def_get_f64"), std::string::npos);
  EXPECT_EQ(hfrac_sim_def_get_i64(&def, "well[0].radius", &value), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_get_i64(&def, "well[1].control", &value), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_get_i64(&def, "model.sead", &value), HFRAC_ERR_UNKNOWN_KEY);
  EXPECT_NE(last_error().find("model.seed"), std::string::npos);
  EXPECT_EQ(value, -77);
  EXPECT_EQ(hfrac_sim_def_get_str(&def, "well[0].radios", text, 8, nullptr), HFRAC_ERR_UNKNOWN_KEY);
  EXPECT_EQ(hfrac_sim_def_get_str(&def, "title", nullptr, 8, nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_get_i64(nullptr, "model.seed", &value), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_get_i64(&def, nullptr, &value), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_get_i64(&def, "model.seed", nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_get_str(&def, nullptr, text, 8, nullptr), HFRAC_ERR_ARGUMENT);
  hfrac::Definition out = cracking_def();
  out.boundary_kind = 7;  // by plain assignment; the text must not read beyond the words
  EXPECT_EQ(text_of(out, "boundary.kind"), "7");
  out.well_count = 1000;
  EXPECT_EQ(hfrac_sim_def_get_i64(&out, "well[900].control", &value), HFRAC_ERR_ARGUMENT);
}

TEST(WellOptions, AreListedLikeTheOthers) {
  int32_t count = 0;
  ASSERT_EQ(hfrac_well_option_count(&count), HFRAC_OK);
  ASSERT_GE(count, 7);
  hfrac::Definition def = new_def();
  for (int32_t i = 0; i < count; ++i) {
    const auto info = read_struct<hfrac_option_info>([&](auto* to) { return hfrac_well_option_at(i, to); });
    EXPECT_NE(std::strlen(info.help), 0U) << info.key;
    EXPECT_LE(info.minimum, info.maximum) << info.key;
    EXPECT_EQ(info.type == 2, info.choices != nullptr) << info.key;
    const std::string key = "well[0]." + std::string(info.key);
    const int32_t status = info.type != 0 ? hfrac_sim_def_set_i64(&def, key.c_str(), 1)
                                          : hfrac_sim_def_set_f64(&def, key.c_str(), info.maximum);
    EXPECT_EQ(status, HFRAC_OK) << key << ": " << last_error();
  }
  hfrac_option_info info{};
  info.struct_size = sizeof info;
  EXPECT_EQ(hfrac_well_option_at(count, &info), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_well_option_at(-1, &info), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_well_option_count(nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_well_option_at(0, nullptr), HFRAC_ERR_ARGUMENT);
}

TEST(WellOptions, AWellAddedByKeyLiesInTheMiddle) {
  hfrac::Definition def = new_def();
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "model.width", 60.0), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "well[0].radius", 5.0), HFRAC_OK);
  EXPECT_EQ(def.well_count, 1);
  EXPECT_EQ(def.wells[0].x, 30.0);
  EXPECT_EQ(def.wells[0].y, 50.0);
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "well[0].x", 20.0), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "well[0].pressure", 3e7), HFRAC_OK);
  EXPECT_EQ(def.wells[0].x, 20.0) << "a well that is there stays where it is";
}

TEST(FieldNames, TheNearestIsNamed) {
  int32_t field = -77;
  EXPECT_EQ(hfrac_field_find("disc.postion", &field), HFRAC_ERR_UNKNOWN_KEY);
  EXPECT_EQ(last_error(), "disc.postion is not a field; did you mean disc.position?");
  EXPECT_EQ(hfrac_field_find("domain.presure", &field), HFRAC_ERR_UNKNOWN_KEY);
  EXPECT_NE(last_error().find("domain.pressure"), std::string::npos);
  EXPECT_EQ(hfrac_field_find("", &field), HFRAC_ERR_UNKNOWN_KEY);
  const std::string long_name(100000, 'q');
  EXPECT_EQ(hfrac_field_find(long_name.c_str(), &field), HFRAC_ERR_UNKNOWN_KEY);
  EXPECT_NE(last_error().find("HFRAC_FIELD_LIST"), std::string::npos);
  EXPECT_EQ(field, -77);
}

}  // namespace keyed_test
