// SPDX-License-Identifier: BSD-3-Clause
// The seismic catalogue: which cracks are one event, what its moment is, and the b value of a known distribution.
#include "frac/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace catalogue_test {

using namespace hfrac;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

CatalogueCrack crack_at(double x, double y, double time = 0.0, std::int64_t cycle = 0) {
  CatalogueCrack crack;
  crack.position = {x, y};
  crack.normal = {1.0, 0.0};
  crack.distance = 1.0;
  crack.normal_force = 1e6;
  crack.energy = 100.0;
  crack.length = 0.8;
  crack.time = time;
  crack.cycle = cycle;
  return crack;
}

std::vector<SeismicEvent> events_of(const std::vector<CatalogueCrack>& cracks,
                                    const CatalogueRule& rule = {}) {
  std::vector<std::int64_t> event_of;
  auto events = find_events(cracks, rule, event_of);
  EXPECT_EQ(event_of.size(), cracks.size());
  return events;
}

TEST(Catalogue, OpeningBondIsADipoleOfItsForceAndLever) {
  CatalogueCrack crack = crack_at(0, 0);
  crack.distance = 0.5;
  const auto event = events_of({crack}).front();
  EXPECT_DOUBLE_EQ(event.xx, 0.5e6);
  EXPECT_EQ(event.yy, 0.0);
  EXPECT_EQ(event.xy, 0.0);
  EXPECT_DOUBLE_EQ(event.moment, 0.5e6 / std::numbers::sqrt2);
  EXPECT_NEAR(event.magnitude, 2.0 / 3.0 * std::log10(0.5e6 / std::numbers::sqrt2) - 6.0333, 1e-4);
  EXPECT_DOUBLE_EQ(event.isotropic_fraction, 0.5);
  EXPECT_DOUBLE_EQ(event.energy_magnitude, 2.0 / 3.0 * 2.0 - 2.9);
}

TEST(Catalogue, ShearingBondIsADoubleCouple) {
  CatalogueCrack crack = crack_at(0, 0);
  crack.normal_force = 0.0;
  crack.shear_force = 3e6;
  crack.distance = 2.0;
  const auto event = events_of({crack}).front();
  EXPECT_DOUBLE_EQ(event.xy, 3e6);
  EXPECT_EQ(event.xx + event.yy, 0.0);
  EXPECT_DOUBLE_EQ(event.moment, 3e6);  // half of force times lever: the part without turning
  EXPECT_DOUBLE_EQ(event.isotropic_fraction, 0.0);
}

TEST(Catalogue, MomentDoesNotDependOnTheDirectionAndGrowsWithThickness) {
  CatalogueCrack crack = crack_at(0, 0);
  crack.shear_force = -0.4e6;
  const auto straight = events_of({crack}).front();
  crack.normal = {std::cos(0.7), std::sin(0.7)};
  const auto turned = events_of({crack}, {.thickness = 10.0}).front();
  EXPECT_NEAR(turned.moment, 10.0 * straight.moment, 1e-9 * turned.moment);
  EXPECT_NEAR(turned.isotropic_fraction, straight.isotropic_fraction, 1e-12);
  EXPECT_DOUBLE_EQ(turned.energy, 10.0 * straight.energy);
}

TEST(Catalogue, LinksCracksNearInSpace) {
  // Discs are 1 m apart, so cracks link up to 2 m: 0, 1.9, 3.8 by way of the middle one; 6 stands alone.
  const std::vector<CatalogueCrack> cracks = {crack_at(0, 0), crack_at(6, 0), crack_at(3.8, 0),
                                              crack_at(1.9, 0)};
  std::vector<std::int64_t> event_of;
  const auto events = find_events(cracks, {}, event_of);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(event_of, (std::vector<std::int64_t>{0, 1, 0, 0}));
  EXPECT_EQ(events[0].crack_count, 3);
  EXPECT_EQ(events[1].first_crack, 1);
  EXPECT_DOUBLE_EQ(events[0].position.x, 1.9);
  EXPECT_DOUBLE_EQ(events[0].radius, 1.9);
  EXPECT_DOUBLE_EQ(events[0].xx, 3e6);
  EXPECT_EQ(events_of(cracks, {.link = {.distance = 1.0}}).size(), 4u);
  EXPECT_EQ(events_of(cracks, {.link = {.distance = 2.3}}).size(), 1u);
}

TEST(Catalogue, LinksCracksNearInTime) {
  const std::vector<CatalogueCrack> cracks = {crack_at(0, 0, 1.0, 10), crack_at(1, 0, 1.0, 60),
                                              crack_at(0.5, 1, 2.0, 70)};
  EXPECT_EQ(events_of(cracks).size(), 2u);
  EXPECT_EQ(events_of(cracks, {.link = {.time_window = 1.0}}).size(), 1u);
  EXPECT_EQ(events_of(cracks, {.link = {.cycle_window = 20}}).size(), 3u);
  EXPECT_EQ(events_of(cracks, {.link = {.time_window = 1.0, .cycle_window = 20}}).size(), 2u);
  const auto event = events_of(cracks).front();
  EXPECT_EQ(event.first_cycle, 10);
  EXPECT_EQ(event.last_cycle, 60);
}

TEST(Catalogue, HasNoEventsWithoutCracksAndNoMagnitudeWithoutForce) {
  EXPECT_TRUE(events_of({}).empty());
  CatalogueCrack crack = crack_at(0, 0);
  crack.normal_force = crack.energy = 0.0;
  const auto event = events_of({crack}).front();
  EXPECT_TRUE(std::isnan(event.magnitude));
  EXPECT_TRUE(std::isnan(event.energy_magnitude));
  EXPECT_EQ(event.isotropic_fraction, 0.0);
}

// Magnitudes at the middles of equal shares of an exponential distribution of b = 1.2 above -1.
std::vector<double> known_magnitudes(std::size_t count) {
  std::vector<double> magnitudes;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    magnitudes.push_back(-1.0 - std::log10(share) / 1.2);
  }
  return magnitudes;
}

TEST(MagnitudeLaw, FindsTheSlopeOfAKnownDistribution) {
  const auto magnitudes = known_magnitudes(4000);
  const auto law = magnitude_law(magnitudes, -1.0);
  EXPECT_EQ(law.count, 4000);
  EXPECT_NEAR(law.b, 1.2, 1e-3);
  EXPECT_NEAR(law.b_error, 1.2 / std::sqrt(4000.0), 1e-4);
  EXPECT_NEAR(law.a, std::log10(4000.0) - 1.2, 2e-3);
  const auto found = magnitude_law(magnitudes, nan);
  EXPECT_DOUBLE_EQ(found.completeness, -1.0);
  EXPECT_EQ(found.b, law.b);
  EXPECT_NEAR(magnitude_law(magnitudes, 0.0).b, 1.2, 0.02);
}

TEST(MagnitudeLaw, SaysNothingOfTooFewOrEqualMagnitudes) {
  EXPECT_EQ(magnitude_law(std::vector<double>{}, nan).b, 0.0);
  EXPECT_EQ(magnitude_law(std::vector<double>{-1.0}, nan).b, 0.0);
  EXPECT_EQ(magnitude_law(std::vector<double>{-1.0, -1.0, -1.0}, -1.0).b, 0.0);
  EXPECT_EQ(magnitude_law(std::vector<double>{nan, 0.5, 1.0, nan}, 0.0).count, 2);
}

}  // namespace catalogue_test
