// SPDX-License-Identifier: BSD-3-Clause
// Events from slip: the moment of a known slip, and which slips are one event.
#include "frac/slip_events.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slip_events_test {

using namespace hfrac;

CatalogueSlip slip_at(double x, double y, double time = 1.0) {
  CatalogueSlip slip;
  slip.position = {x, y};
  slip.normal = {0.0, 1.0};
  slip.length = 2.0;
  slip.slip = 0.02;
  slip.disc_distance = 1.0;
  slip.shear_modulus = 25e9;
  slip.time = time;
  slip.duration = 0.5;
  slip.bond = static_cast<std::int64_t>(1000.0 * x + y);
  return slip;
}

TEST(SlipEvents, MomentIsModulusTimesAreaTimesSlip) {
  // 25 GPa, 2 m by 10 km, 20 mm: 1e13 N m, 1e20 dyn cm, which Hanks and Kanamori (1979) rate 2/3 20 - 10.7.
  const auto events = find_slip_events(std::vector{slip_at(0, 0)}, {.thickness = 1e4});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(events[0].moment, 1e13, 1.0);
  EXPECT_NEAR(events[0].magnitude, 2.0 / 3.0 * 20.0 - 10.7, 1e-12);
  EXPECT_EQ(events[0].isotropic_fraction, 0.0);
  EXPECT_EQ(events[0].kind, EventKind::slip);
  EXPECT_EQ(events[0].slip, 0.02);
}

TEST(SlipEvents, TensorIsThatOfTheMotion) {
  // The upper side moves to the left (t is -x for n = y): its displacement falls with y, so xy is below 0. At 45 degrees the same pulls
  // along one axis and presses along the other.
  auto slip = slip_at(0, 0);
  const double moment = 25e9 * 2.0 * 0.02;
  auto event = find_slip_events(std::vector{slip}, {}).at(0);
  EXPECT_NEAR(event.xy, -moment, 1e-6);
  EXPECT_EQ(event.xx, 0.0);
  slip.normal = {std::sqrt(0.5), std::sqrt(0.5)};
  event = find_slip_events(std::vector{slip}, {}).at(0);
  EXPECT_NEAR(event.xx, -moment, 1e-6);
  EXPECT_NEAR(event.yy, moment, 1e-6);
  EXPECT_NEAR(event.xy, 0.0, 1e-6);
  // Seen from the other side it is the same motion.
  slip.normal = -1.0 * slip.normal;
  EXPECT_NEAR(find_slip_events(std::vector{slip}, {}).at(0).xx, -moment, 1e-6);
}

TEST(SlipEvents, OfAStraightJointAddUpWhateverTheLinks) {
  std::vector<CatalogueSlip> slips;
  for (int k = 0; k < 10; ++k) slips.push_back(slip_at(k, 0.0, k < 6 ? 1.0 : 2.0));
  slips[3].slip = 0.05;
  const double moment = 25e9 * 2.0 * (9 * 0.02 + 0.05);
  const auto apart = find_slip_events(slips, {});  // a front that moves on is an event per increment
  ASSERT_EQ(apart.size(), 2u);
  EXPECT_EQ(apart[0].slip_count, 6);
  EXPECT_NEAR(apart[0].moment + apart[1].moment, moment, 1e-6 * moment);
  const auto together = find_slip_events(slips, {.link = {.time_window = 1.0}});
  ASSERT_EQ(together.size(), 1u);
  EXPECT_NEAR(together[0].moment, moment, 1e-6 * moment);
  EXPECT_EQ(together[0].duration, 1.0);
  EXPECT_EQ(together[0].length, 20.0);
  // One that is more than two disc distances away stands alone.
  slips.push_back(slip_at(11.5, 0.0, 2.0));
  EXPECT_EQ(find_slip_events(slips, {.link = {.time_window = 1.0}}).size(), 2u);
}

TEST(SlipEvents, AContactThatSlipsTwiceCountsItsLengthOnce) {
  auto again = slip_at(0, 0, 2.0);
  const auto event =
      find_slip_events(std::vector{slip_at(0, 0, 1.0), again}, {.link = {.time_window = 5.0}}).at(0);
  EXPECT_EQ(event.length, 2.0);
  EXPECT_NEAR(event.slip, 0.04, 1e-15);
}

TEST(SlipEvents, SlowSlipIsLeftOutByItsRate) {
  // 20 mm in half a second.
  EXPECT_EQ(find_slip_events(std::vector{slip_at(0, 0)}, {.slip_rate = 0.039}).size(), 1u);
  EXPECT_TRUE(find_slip_events(std::vector{slip_at(0, 0)}, {.slip_rate = 0.041}).empty());
}

}  // namespace slip_events_test
