// SPDX-License-Identifier: BSD-3-Clause
// Numbers on scales: two or more whatever the range, none outside it, and the unit of every field.
#include <gtest/gtest.h>

#include <cmath>

#include "../../viz/render/number_text.h"
#include "run/fields.hpp"

namespace hfrac::viz_test {
namespace {

using viz::quantity_of;
using viz::round_ticks;
using viz::Tick;

TEST(Ticks, AreTwoOrMoreInAnyRange) {
  for (int wanted = 1; wanted <= 8; ++wanted) {
    for (double highest = 0.01; highest < 300; highest *= 1.037) {
      for (const double from : {0.0, -1.0, -0.3, 0.01, 0.9}) {
        const double lowest = from * highest, slack = 1e-5 * (highest - lowest);
        const std::vector<Tick> ticks = round_ticks(lowest, highest, wanted);
        ASSERT_GE(ticks.size(), 2U) << lowest << " to " << highest << ", " << wanted << " wanted";
        EXPECT_LE(ticks.size(), 2U * static_cast<std::size_t>(wanted) + 4U);
        EXPECT_GE(ticks.front().value, lowest - slack);
        EXPECT_LE(ticks.back().value, highest + slack);
        for (const Tick& tick : ticks) EXPECT_NEAR(std::stod(tick.text), tick.value, 1e-9);
        EXPECT_NE(ticks[0].text, ticks[1].text);
      }
    }
  }
}

TEST(Ticks, EveryFieldIsShownInItsUnit) {
  for (const run::Field& field : run::all_fields()) {
    for (const double largest : {1e-9, 1e-3, 1.0, 1e7}) {
      const viz::Quantity quantity = quantity_of(run::array_name(field), largest);
      EXPECT_EQ(quantity.unit.empty(), field.unit == "1") << field.key << " [" << field.unit << "]";
    }
  }
}

}  // namespace
}  // namespace hfrac::viz_test
