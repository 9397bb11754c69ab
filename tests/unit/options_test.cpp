// SPDX-License-Identifier: BSD-3-Clause
// The option table seen from inside: keys, words, nearest names, numbers as text, the expected radius of a
// packing.
#include "options/options.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "core/error.hpp"
#include "options/choices.hpp"
#include "options/model_size.hpp"
#include "options/nearest.hpp"
#include "options/number_text.hpp"

namespace options_test {

using namespace hfrac;

TEST(OptionTable, EveryRowIsReachableAndDescribed) {
  std::set<std::string> keys;
  const Options defaults;
  for (const auto& info : option_table()) {
    EXPECT_TRUE(keys.insert(info.key).second) << info.key << " appears twice";
    EXPECT_EQ(find_option(info.key), &info);
    EXPECT_EQ(get_value(defaults, info), info.initial) << info.key;
    EXPECT_NE(std::string(info.help), "") << info.key;
    EXPECT_NE(info.real == nullptr, info.integer == nullptr) << info.key;
  }
  // Nothing but the table's members is in the struct, and nothing is missing: all are eight bytes.
  EXPECT_EQ(sizeof(Options), 8 * option_table().size());
  EXPECT_EQ(sizeof(WellOptions), 8 * well_option_table().size());
  EXPECT_EQ(find_option("bond"), nullptr);
  EXPECT_EQ(find_option(""), nullptr);
}

TEST(Choices, WordsAndIndicesBelongTogether) {
  static_assert(choice_count("a|b|c") == 3 && choice_count("a") == 1);
  static_assert(choice_index("a|bb|c", "bb") == 1 && choice_index("a|bb|c", "b") == -1 &&
                choice_index("a|b", "a|b") == -1);
  static_assert(choice_word("a|bb|c", 0) == "a" && choice_word("a|bb|c", 1) == "bb" &&
                choice_word("a|bb|c", 2) == "c");
}

TEST(Nearest, DistancesCountEdits) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("radius", "raduis"), 1u);
}

TEST(Nearest, SuggestsOnlyWhatIsNear) {
  const std::string_view names[] = {"radius", "pressure", "rate"};
  EXPECT_EQ(nearest_name("radus", names), "radius");
  EXPECT_EQ(nearest_name("RATE", names), "");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name("temperature_of_the_fluid", names), "");
}

TEST(NumberText, IsShortestAndReadsBack) {
  EXPECT_EQ(number_text(0.2), "0.2");
  EXPECT_EQ(number_text(1e12), "1e12");
  EXPECT_EQ(number_text(1e-7), "1e-7");
  EXPECT_EQ(number_text(1e-100), "1e-100");
  EXPECT_EQ(number_text(100.0), "100");
  EXPECT_EQ(number_text(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
  for (const double value : {1.0 / 3.0, 5.527e-15, -0.0, 5e-324, std::numeric_limits<double>::max()}) {
    EXPECT_EQ(std::stod(number_text(value == 5e-324 ? 1e-300 : value)), value == 5e-324 ? 1e-300 : value);
  }
  EXPECT_EQ(rounded_text(0.81649), "0.816");
}

TEST(Validate, NamesKeyValueAndRange) {
  CaseDefinition definition;
  definition.options.packing_porosity = 0.9;
  try {
    validate(definition);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::argument);
    EXPECT_STREQ(error.what(), "packing.porosity = 0.9 is outside 0.08 to 0.2.");
  }
}

// Up to where each way of solving counts in 32 bits, and not beyond.
TEST(ModelSize, WhatSolvesForAllDiscsAtOnceEndsEarlier) {
  constexpr std::int64_t ten_millions = 10'000'000, most = 100'000'000;
  CaseDefinition rock;
  EXPECT_EQ(why_too_large(rock, most), "");
  const auto refusal = [&](auto change, std::int64_t discs) {
    CaseDefinition definition = rock;
    change(definition.options);
    return why_too_large(definition, discs);
  };
  const auto quasi_static = [](Options& o) {
    o.solver_kind = static_cast<std::int64_t>(SolverKind::quasi_static);
  };
  EXPECT_EQ(refusal(quasi_static, ten_millions), "");
  EXPECT_EQ(
      refusal(quasi_static, ten_millions + 1),
      "10000001 discs are more than the 10000000 that solver.kind = \"quasi-static\" takes; give fewer, "
      "or set solver.kind = \"explicit\".");
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(has(refusal([](Options& o) { o.bond_fracture_toughness = 1e6; }, most),
                  "fracture.law = \"facet\", which \"auto\" is here,"));
  EXPECT_TRUE(has(
      refusal([](Options& o) { o.flow_solver = static_cast<std::int64_t>(FlowMatrixSolver::direct); }, most),
      "flow.solver = \"direct\""));
  EXPECT_TRUE(has(
      refusal([](Options& o) { o.thermal_mode = static_cast<std::int64_t>(ThermalMode::transport); }, most),
      "thermal.mode = \"transport\""));
}

// Before the system ends the host's program for it.
TEST(ModelSize, IsRefusedByAMachineThatCannotHoldIt) {
  constexpr double gib = 1024.0 * 1024.0 * 1024.0;
  CaseDefinition definition;
  EXPECT_EQ(why_no_memory(definition, 1'000'000, true, 2.0 * gib), "");
  EXPECT_EQ(why_no_memory(definition, 100'000'000, true, 64.0 * gib),
            "a model of 100000000 discs takes 79.2 GiB at least, and this machine has 64 GiB, swap included; "
            "lower packing.disc_count or give fewer discs.");
  definition.options.flow_scheme = static_cast<std::int64_t>(FlowScheme::off);
  EXPECT_EQ(why_no_memory(definition, 100'000'000, true, 64.0 * gib), "");
  definition.options.solver_kind = static_cast<std::int64_t>(SolverKind::quasi_static);
  EXPECT_NE(why_no_memory(definition, 10'000'000, true, 16.0 * gib), "");
  // Over ranks the factor is shared out.
  EXPECT_EQ(why_no_memory(definition, 10'000'000, false, 16.0 * gib), "");
  EXPECT_GT(machine_memory(), 0.1 * gib);
}

TEST(ExpectedRadius, FillsTheModel) {
  Options o;
  o.packing_radius_ratio = 1.0;
  const double r = expected_mean_radius(o);
  EXPECT_NEAR(10000.0 * 3.14159265358979 * r * r, 0.85 * 100.0 * 100.0, 1e-6);
  // Spread radii fill the same area with a smaller mean: average their squares directly.
  o.packing_radius_ratio = 2.7;
  const double mean = expected_mean_radius(o), smallest = 2.0 * mean / 3.7;
  double squares = 0.0;
  for (int i = 0; i < 10000; ++i) squares += std::pow(smallest * (1.0 + 1.7 * (i + 0.5) / 10000.0), 2);
  EXPECT_NEAR(3.14159265358979 * squares, 0.85 * 100.0 * 100.0, 1e-2);
}

}  // namespace options_test
