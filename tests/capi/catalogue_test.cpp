// SPDX-License-Identifier: BSD-3-Clause
// Events of a simulation's cracks, through the interface: what they add up to, sizes, and refusals.
#include <cmath>
#include <limits>

#include "sim_support.hpp"

namespace catalogue_test {

using namespace testing_capi;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class Catalogue : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    hfrac::Definition def = cracking_def(1000);
    def.bond_tensile_strength = 30e6;
    def.bond_shear_strength = 15e6;
    def.stepping_flow_step = 0.5;
    hfrac_sim* sim = nullptr;
    ASSERT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK) << last_error();
    ASSERT_EQ(hfrac_step(sim, 4), HFRAC_OK) << last_error(sim);
    cracks = cracks_of(sim);
    hfrac_sim_destroy(&sim);
    ASSERT_GT(cracks.size(), 20u);
  }
  static int32_t find(const hfrac_catalogue_options* options, std::vector<hfrac_event>& events) {
    int64_t count = 0;
    const auto size = static_cast<int64_t>(cracks.size());
    const int32_t status = hfrac_find_events(cracks.data(), sizeof(hfrac_crack), size, options,
                                             sizeof(hfrac_event), nullptr, 0, &count);
    if (status != HFRAC_OK) return status;
    events.resize(static_cast<std::size_t>(count));
    return hfrac_find_events(cracks.data(), sizeof(hfrac_crack), size, options, sizeof(hfrac_event),
                             events.data(), count, &count);
  }
  static std::vector<hfrac_crack> cracks;
};
std::vector<hfrac_crack> Catalogue::cracks;

TEST_F(Catalogue, HoldsEveryCrackOnce) {
  std::vector<hfrac_event> events;
  ASSERT_EQ(find(nullptr, events), HFRAC_OK) << last_error();
  ASSERT_GT(events.size(), 1u);
  ASSERT_LT(events.size(), cracks.size());
  std::vector<int64_t> event_of(cracks.size());
  int64_t count = 0;
  const auto size = static_cast<int64_t>(cracks.size());
  ASSERT_EQ(hfrac_find_event_of_cracks(cracks.data(), sizeof(hfrac_crack), size, nullptr, event_of.data(),
                                       size, &count),
            HFRAC_OK);
  EXPECT_EQ(count, size);
  int64_t sum = 0;
  double energy = 0, crack_energy = 0;
  for (const auto& crack : cracks) crack_energy += crack.energy;
  for (std::size_t e = 0; e < events.size(); ++e) {
    const hfrac_event& event = events[e];
    EXPECT_EQ(event.index, static_cast<int64_t>(e));
    EXPECT_EQ(event.time, cracks[static_cast<std::size_t>(event.first_crack)].time);
    EXPECT_GT(event.moment, 0.0);
    EXPECT_LE(std::abs(event.isotropic_fraction), 1.0);
    const auto members = std::count(event_of.begin(), event_of.end(), event.index);
    EXPECT_EQ(event.crack_count, members);
    sum += event.crack_count;
    energy += event.energy;
  }
  EXPECT_EQ(sum, size);
  EXPECT_NEAR(energy, crack_energy, 1e-12 * crack_energy);
  // Discs of one size press into each other a little.
  for (const auto& crack : cracks) EXPECT_GT(crack.distance, 0.95 * crack.length);
}

TEST_F(Catalogue, TakesWindowsAndThickness) {
  std::vector<hfrac_event> own, apart, thick;
  hfrac_catalogue_options options{};
  options.struct_size = sizeof options;
  ASSERT_EQ(find(&options, own), HFRAC_OK);
  options.distance = 1e-6;
  ASSERT_EQ(find(&options, apart), HFRAC_OK);
  EXPECT_EQ(apart.size(), cracks.size());
  options.distance = 0.0;
  options.thickness = 8.0;
  ASSERT_EQ(find(&options, thick), HFRAC_OK);
  ASSERT_EQ(thick.size(), own.size());
  EXPECT_NEAR(thick[0].magnitude, own[0].magnitude + 2.0 / 3.0 * std::log10(8.0), 1e-12);
}

TEST_F(Catalogue, RefusesWhatCannotBe) {
  std::vector<hfrac_event> events;
  hfrac_catalogue_options options{};
  options.struct_size = sizeof options;
  for (const double bad : {-1.0, nan}) {
    options.distance = bad;
    EXPECT_EQ(find(&options, events), HFRAC_ERR_ARGUMENT);
    EXPECT_NE(last_error().find("distance"), std::string::npos);
  }
  int64_t count = 0;
  hfrac_crack crack = cracks[0];
  crack.normal_force = nan;
  EXPECT_EQ(hfrac_find_events(&crack, sizeof crack, 1, nullptr, sizeof(hfrac_event), nullptr, 0, &count),
            HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_find_events(&crack, 8, 1, nullptr, sizeof(hfrac_event), nullptr, 0, &count),
            HFRAC_ERR_STRUCT_SIZE);
  EXPECT_EQ(hfrac_find_events(nullptr, sizeof crack, 1, nullptr, sizeof(hfrac_event), nullptr, 0, &count),
            HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_find_events(&crack, sizeof crack, -1, nullptr, sizeof(hfrac_event), nullptr, 0, &count),
            HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_find_event_of_cracks(&crack, sizeof crack, 1, nullptr, nullptr, 0, nullptr),
            HFRAC_ERR_ARGUMENT);
}

TEST(MagnitudeLawFromC, GivesTheLikelihoodsSlope) {
  const double magnitudes[] = {0.0, 0.1, 0.2, 0.5, nan};
  hfrac_magnitude_law law{};
  law.struct_size = sizeof law;
  ASSERT_EQ(hfrac_find_magnitude_law(magnitudes, 5, 0.0, &law), HFRAC_OK);
  EXPECT_EQ(law.count, 4);
  EXPECT_NEAR(law.b, 0.4342944819 / 0.2, 1e-9);
  EXPECT_NEAR(law.b_error, law.b / 2.0, 1e-12);
  EXPECT_EQ(hfrac_find_magnitude_law(magnitudes, 5, std::numeric_limits<double>::infinity(), &law),
            HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_find_magnitude_law(magnitudes, 5, nan, nullptr), HFRAC_ERR_ARGUMENT);
}

}  // namespace catalogue_test
