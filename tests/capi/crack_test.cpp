// SPDX-License-Identifier: BSD-3-Clause
// The log of cracks and its cursor; fractures and what they are made of.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>
#include <set>

#include "sim_support.hpp"

namespace crack_test {

using namespace testing_capi;

constexpr std::size_t at(int64_t index) {
  return static_cast<std::size_t>(index);
}

// One simulation of weak rock: cracks in tension and shear, some of them away from the well.
class Cracks : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    hfrac::Definition def = cracking_def(1000);
    def.bond_tensile_strength = 30e6;
    def.bond_shear_strength = 15e6;
    def.stepping_flow_step = 0.5;
    ASSERT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK) << last_error();
    for (int k = 0; k < 4; ++k) {
      ASSERT_GE(hfrac_step(sim, 1), HFRAC_OK) << last_error(sim);
      counts.push_back(state_of(sim).crack_count);
    }
    fractures = fractures_of(sim);
    cracks = cracks_of(sim);
    ASSERT_GT(cracks.size(), 20u);
  }
  static void TearDownTestSuite() { hfrac_sim_destroy(&sim); }

  static hfrac_sim* sim;
  static std::vector<int64_t> counts;      // cracks after each step
  static std::vector<hfrac_crack> cracks;  // after
  static std::vector<hfrac_fracture> fractures;
};
hfrac_sim* Cracks::sim = nullptr;
std::vector<int64_t> Cracks::counts;
std::vector<hfrac_crack> Cracks::cracks;
std::vector<hfrac_fracture> Cracks::fractures;

TEST_F(Cracks, AreNumberedInOrderOfBreakage) {
  const auto state = state_of(sim);
  EXPECT_EQ(static_cast<int64_t>(cracks.size()), state.crack_count);
  int64_t tension = 0, setup = 0;
  for (std::size_t k = 0; k < cracks.size(); ++k) {
    EXPECT_EQ(cracks[k].id, static_cast<int64_t>(k));
    EXPECT_GE(cracks[k].step, 0);
    EXPECT_LE(cracks[k].step, state.step);
    EXPECT_LE(cracks[k].cycle, state.cycles);
    EXPECT_EQ(cracks[k].time, 0.5 * static_cast<double>(cracks[k].step));
    if (k > 0) {
      EXPECT_GE(cracks[k].cycle, cracks[k - 1].cycle);
      EXPECT_GE(cracks[k].step, cracks[k - 1].step);
    }
    if (cracks[k].step > 0) {
      EXPECT_LT(cracks[k].id, counts[at(cracks[k].step) - 1]);
    }
    tension += cracks[k].mode == HFRAC_CRACK_TENSION ? 1 : 0;
    setup += cracks[k].step == 0 ? 1 : 0;
  }
  EXPECT_EQ(tension, state.tensile_cracks);
  EXPECT_EQ(setup, state.equilibration_cracks);
  EXPECT_GT(state.shear_cracks, 0);
}

TEST_F(Cracks, AreTheBrokenBonds) {
  const auto bond_state = indices(sim, HFRAC_BOND_STATE), discs = indices(sim, HFRAC_BOND_DISCS);
  const auto position = doubles(sim, HFRAC_DISC_POSITION), gap = doubles(sim, HFRAC_BOND_GAP),
             radius = doubles(sim, HFRAC_DISC_RADIUS);
  EXPECT_EQ(bond_state.size() - at(std::count(bond_state.begin(), bond_state.end(), 0)), cracks.size());
  std::vector<int64_t> bonds;
  for (const auto& c : cracks) {
    bonds.push_back(c.bond);
    EXPECT_EQ(bond_state[at(c.bond)], c.mode);
    EXPECT_EQ(discs[at(2 * c.bond)], c.disc[0]);
    EXPECT_EQ(discs[at(2 * c.bond + 1)], c.disc[1]);
    EXPECT_EQ(c.aperture, std::max(0.0, gap[at(c.bond)]));
    EXPECT_NEAR(c.length, 2.0 * std::min(radius[at(c.disc[0])], radius[at(c.disc[1])]), 1e-12);
    EXPECT_GT(c.energy, 0.0);
    // Between its discs, across the line from the one to the other.
    EXPECT_NEAR(std::hypot(c.normal[0], c.normal[1]), 1.0, 1e-12);
    const double* from = &position[at(2 * c.disc[0])];
    const double* to = &position[at(2 * c.disc[1])];
    const double distance = std::hypot(to[0] - from[0], to[1] - from[1]);
    EXPECT_NEAR(c.normal[0], (to[0] - from[0]) / distance, 1e-3);
    EXPECT_NEAR(c.normal[1], (to[1] - from[1]) / distance, 1e-3);
    const double way = std::hypot(c.position[0] - from[0], c.position[1] - from[1]) +
                       std::hypot(c.position[0] - to[0], c.position[1] - to[1]);
    EXPECT_NEAR(way, distance, 1e-9);
  }
  std::sort(bonds.begin(), bonds.end());
  EXPECT_TRUE(std::adjacent_find(bonds.begin(), bonds.end()) == bonds.end()) << "a bond broke twice";
}

TEST_F(Cracks, OfShearExceededTheShearStrength) {
  for (const auto& c : cracks) {
    // Bond and contact together; the bond alone had reached its strength times its diameter.
    if (c.mode == HFRAC_CRACK_SHEAR) {
      EXPECT_GE(std::abs(c.shear_force), 15e6 * c.length);
    }
  }
}

TEST_F(Cracks, ArePagedWithACursor) {
  std::vector<hfrac_crack> paged;
  hfrac_crack page[7];
  int64_t cursor = 0, count = -1, next = -1;
  do {
    ASSERT_EQ(hfrac_cracks_since(sim, cursor, sizeof(hfrac_crack), page, 7, &count, &next), HFRAC_OK);
    ASSERT_EQ(next, cursor + count);
    ASSERT_LE(count, 7);
    paged.insert(paged.end(), page, page + count);
    cursor = next;
  } while (count > 0);
  ASSERT_EQ(paged.size(), cracks.size());
  EXPECT_EQ(std::memcmp(paged.data(), cracks.data(), cracks.size() * sizeof(hfrac_crack)), 0);
}

TEST_F(Cracks, SinceACursorAreThoseThatCameAfter) {
  const auto there = static_cast<int64_t>(cracks.size());
  const auto later = cracks_of(sim, counts[0]);
  ASSERT_EQ(static_cast<int64_t>(later.size()), there - counts[0]);
  for (const auto& crack : later) EXPECT_GT(crack.step, 1);

  hfrac_crack crack{};
  int64_t count = -1, next = -1;
  // Only how many there are: the cursor stays.
  ASSERT_EQ(hfrac_cracks_since(sim, 2, sizeof crack, nullptr, 0, &count, &next), HFRAC_OK);
  EXPECT_EQ(count, there - 2);
  EXPECT_EQ(next, 2);
  ASSERT_EQ(hfrac_cracks_since(sim, there, sizeof crack, &crack, 1, &count, &next), HFRAC_OK);
  EXPECT_EQ(count, 0);
  EXPECT_EQ(next, there);
  ASSERT_EQ(hfrac_cracks_since(sim, 0, sizeof crack, &crack, 0, &count, &next), HFRAC_OK);
  EXPECT_EQ(count, 0);
  EXPECT_EQ(next, 0);
  EXPECT_EQ(hfrac_cracks_since(sim, 0, sizeof crack, &crack, 1, &count, nullptr),
            HFRAC_OK);  // next not wanted
  for (const int64_t cursor : {int64_t{-1}, there + 1, INT64_MAX, INT64_MIN}) {
    EXPECT_EQ(hfrac_cracks_since(sim, cursor, sizeof crack, &crack, 1, &count, &next), HFRAC_ERR_ARGUMENT);
    EXPECT_EQ(last_error(sim), "cursor = " + std::to_string(cursor) + " is outside 0 to " +
                                   std::to_string(there) + ", the cracks there are.");
  }
  EXPECT_EQ(hfrac_cracks_since(sim, 0, sizeof crack, &crack, -1, &count, &next), HFRAC_ERR_ARGUMENT);
}

// Items of the sizes that callers of other headers have: `stride` bytes each, the rest of the memory
// untouched.
template <class Struct, class Fetch>
void expect_items(const std::vector<Struct>& wanted, std::size_t stride, Fetch fetch) {
  constexpr unsigned char untouched = 0xEE;
  const std::size_t items = 3;
  std::vector<unsigned char> memory(items * stride + 16, untouched);
  int64_t count = 0;
  ASSERT_EQ(fetch(static_cast<int32_t>(stride), reinterpret_cast<Struct*>(memory.data()), 3, &count),
            HFRAC_OK);
  const std::size_t common = std::min(stride, sizeof(Struct));
  for (std::size_t k = 0; k < items; ++k) {
    EXPECT_EQ(std::memcmp(&memory[k * stride], &wanted[k], common), 0) << stride;
    for (std::size_t b = common; b < stride; ++b) EXPECT_EQ(memory[k * stride + b], 0) << stride;
  }
  for (std::size_t b = items * stride; b < memory.size(); ++b) EXPECT_EQ(memory[b], untouched) << stride;
}

TEST_F(Cracks, FitOlderAndNewerCallers) {
  for (const std::size_t size :
       {offsetof(hfrac_crack, position), sizeof(hfrac_crack), sizeof(hfrac_crack) + 24}) {
    expect_items(cracks, size, [](int32_t stride, hfrac_crack* to, int64_t capacity, int64_t* count) {
      return hfrac_cracks_since(sim, 0, stride, to, capacity, count, nullptr);
    });
  }
  ASSERT_GE(fractures.size(), 3u);
  for (const std::size_t size :
       {offsetof(hfrac_fracture, reach), sizeof(hfrac_fracture), sizeof(hfrac_fracture) + 24}) {
    expect_items(fractures, size, [](int32_t stride, hfrac_fracture* to, int64_t capacity, int64_t* count) {
      return hfrac_fractures(sim, stride, to, capacity, count);
    });
  }
  hfrac_crack crack{};
  hfrac_fracture fracture{};
  int64_t count = -1, next = -1;
  for (const int32_t size : {0, -1, 7, 1 << 20, INT32_MAX, INT32_MIN}) {
    EXPECT_EQ(hfrac_cracks_since(sim, 0, size, &crack, 1, &count, &next), HFRAC_ERR_STRUCT_SIZE) << size;
    EXPECT_NE(last_error(sim).find("crack_size = " + std::to_string(size)), std::string::npos);
    EXPECT_EQ(hfrac_fractures(sim, size, &fracture, 1, &count), HFRAC_ERR_STRUCT_SIZE) << size;
    EXPECT_NE(last_error(sim).find("fracture_size = " + std::to_string(size)), std::string::npos);
  }
  EXPECT_EQ(count, -1);
}

TEST_F(Cracks, AreALineFromTipToTip) {
  const auto line_of = [](int64_t fracture) {
    int64_t count = -1;
    EXPECT_EQ(hfrac_fracture_line(sim, fracture, sizeof(hfrac_fracture_point), nullptr, 0, &count), HFRAC_OK);
    std::vector<hfrac_fracture_point> line(at(count));
    EXPECT_EQ(hfrac_fracture_line(sim, fracture, sizeof(hfrac_fracture_point), line.data(), count, &count),
              HFRAC_OK);
    return line;
  };
  for (const auto& fracture : fractures) {
    SCOPED_TRACE("fracture " + std::to_string(fracture.index));
    const auto line = line_of(fracture.index);
    ASSERT_GT(line.size(), 0u);
    double length = 0.0;
    std::set<int64_t> bonds;
    for (std::size_t k = 0; k < line.size(); ++k) {
      const auto& p = line[k];
      length += p.length;
      const auto crack =
          std::find_if(cracks.begin(), cracks.end(), [&](const auto& c) { return c.bond == p.bond; });
      ASSERT_NE(crack, cracks.end());
      EXPECT_EQ(crack->fracture, fracture.index);
      EXPECT_EQ(p.position[0], crack->position[0]);
      EXPECT_EQ(p.aperture, crack->aperture);
      EXPECT_EQ(p.hydraulic_aperture, crack->hydraulic_aperture);
      EXPECT_TRUE(bonds.insert(p.bond).second);
      if (k > 0) {
        EXPECT_GT(p.distance, line[k - 1].distance);
      }
      EXPECT_EQ(p.wing, fracture.well < 0 ? -1 : p.distance < 0.0 ? 0 : 1);
      EXPECT_TRUE(p.saturation >= 0.0 && p.saturation <= 1.0);
    }
    EXPECT_EQ(line.back().tip, 1);
    // The longest way, as hfrac_fractures has it; wings that meet elsewhere than at the well share a part.
    EXPECT_NEAR(length, fracture.length, 1e-9);
  }
  int64_t count = -1;
  EXPECT_EQ(hfrac_fracture_line(sim, static_cast<int64_t>(fractures.size()), sizeof(hfrac_fracture_point),
                                nullptr, 0, &count),
            HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("fracture = "), std::string::npos);
  EXPECT_EQ(count, -1);
}

TEST_F(Cracks, MakeUpFractures) {
  const auto domains = indices(sim, HFRAC_PIPE_DOMAINS);
  const auto well = well_of(sim);
  int64_t sum = 0;
  bool at_the_well = false;
  for (std::size_t k = 0; k < fractures.size(); ++k) {
    SCOPED_TRACE("fracture " + std::to_string(k));
    const auto& f = fractures[k];
    EXPECT_EQ(f.index, static_cast<int64_t>(k));
    if (k > 0) {
      EXPECT_LE(f.crack_count, fractures[k - 1].crack_count);
    }
    // The same from its cracks.
    int64_t count = 0, tensile = 0;
    double length = 0.0, volume = 0.0, widest = 0.0, longest = 0.0;
    bool connected = false;
    for (const auto& c : cracks) {
      if (c.fracture != f.index) continue;
      ++count;
      tensile += c.mode == HFRAC_CRACK_TENSION ? 1 : 0;
      length += c.length;
      longest = std::max(longest, c.length);
      volume += c.length * c.aperture;
      widest = std::max(widest, c.aperture);
      connected |= domains[at(2 * c.bond)] == well.domain || domains[at(2 * c.bond + 1)] == well.domain;
    }
    EXPECT_GT(count, 0);
    EXPECT_EQ(f.crack_count, count);
    EXPECT_EQ(f.tensile_cracks, tensile);
    EXPECT_NEAR(f.volume, volume, 1e-12);
    EXPECT_NEAR(f.mean_aperture, volume / length, 1e-12);
    EXPECT_EQ(f.largest_aperture, widest);
    EXPECT_GT(f.length, 0.0);
    EXPECT_GE(f.extent, longest * (1.0 - 1e-12));
    EXPECT_LE(std::abs(f.azimuth), 0.5 * std::numbers::pi);
    EXPECT_GE(f.wings, 1);
    EXPECT_EQ(f.well, connected ? 0 : -1);
    EXPECT_EQ(f.reach > 0.0, connected);
    EXPECT_TRUE(std::isfinite(f.mean_pressure));
    at_the_well |= connected;
    sum += count;
  }
  EXPECT_EQ(sum, static_cast<int64_t>(cracks.size()));
  EXPECT_TRUE(at_the_well);
  EXPECT_GT(fractures.size(), 1u);
}

TEST_F(Cracks, OfTheLargestFracturesAreCopiedFirst) {
  hfrac_fracture largest{};
  int64_t count = -1;
  ASSERT_EQ(hfrac_fractures(sim, sizeof largest, &largest, 1, &count), HFRAC_OK);
  EXPECT_EQ(count, static_cast<int64_t>(fractures.size()));
  EXPECT_EQ(std::memcmp(&largest, fractures.data(), sizeof largest), 0);
  EXPECT_EQ(hfrac_fractures(sim, sizeof largest, &largest, -1, &count), HFRAC_ERR_ARGUMENT);
}

TEST(CrackRecord, CarriesPressureApertureAndTheFractureTheyAreOfNow) {
  const Sim sim(cracking_def());
  for (int round = 0; round < 2; ++round) {
    ASSERT_GE(hfrac_step(sim, 1), 0);
    const auto cracks = cracks_of(sim);  // nobody has asked for fractures since the step
    const auto fractures = fractures_of(sim);
    ASSERT_FALSE(cracks.empty());
    std::vector<int64_t> members(fractures.size(), 0);
    double highest = 0.0;
    for (const auto& crack : cracks) {
      ASSERT_GE(crack.fracture, 0);
      ASSERT_LT(static_cast<std::size_t>(crack.fracture), fractures.size());
      ++members[static_cast<std::size_t>(crack.fracture)];
      EXPECT_GT(crack.hydraulic_aperture, 0.0);
      highest = std::max(highest, crack.pressure);
    }
    for (std::size_t f = 0; f < fractures.size(); ++f) EXPECT_EQ(members[f], fractures[f].crack_count);
    EXPECT_GT(highest, 0.0);
    EXPECT_LE(highest, well_of(sim).pressure * (1.0 + 1e-9));
  }
}

TEST(CracksOfSoundRock, AreNone) {
  const Sim sim(quiet_def());
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_TRUE(cracks_of(sim).empty());
  EXPECT_TRUE(fractures_of(sim).empty());
  EXPECT_EQ(state_of(sim).tip_distance, 0.0);
}

TEST(CracksOverTime, OnlyGrowInNumber) {
  const Sim sim(cracking_def(1000));
  std::vector<hfrac_crack> known;
  int64_t cursor = 0;
  for (int k = 0; k < 5; ++k) {
    ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
    const auto fresh = cracks_of(sim, cursor);
    for (const auto& crack : fresh) EXPECT_EQ(crack.step, k + 1);
    known.insert(known.end(), fresh.begin(), fresh.end());
    cursor = static_cast<int64_t>(known.size());
  }
  const auto now = cracks_of(sim);
  ASSERT_EQ(now.size(), known.size());
  for (std::size_t k = 0; k < now.size(); ++k) {
    EXPECT_EQ(now[k].bond, known[k].bond);
    EXPECT_EQ(now[k].time, known[k].time);
    EXPECT_EQ(now[k].energy, known[k].energy);
    EXPECT_EQ(now[k].mode, known[k].mode);
  }
}

}  // namespace crack_test
