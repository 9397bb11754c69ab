// SPDX-License-Identifier: BSD-3-Clause
// A packing of the host's own instead of the engine's.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim_support.hpp"

namespace given_discs_test {

using namespace testing_capi;

// Rows of touching discs, every second one shifted by a radius.
std::vector<double> hexagonal(double width, double height, double radius) {
  std::vector<double> discs;
  for (int row = 0; radius + row * radius * std::numbers::sqrt3 + radius <= height; ++row) {
    const double y = radius + row * radius * std::numbers::sqrt3;
    for (double x = row % 2 == 0 ? radius : 2.0 * radius; x + radius <= width; x += 2.0 * radius) {
      discs.insert(discs.end(), {x, y, radius});
    }
  }
  return discs;
}

hfrac::Definition with_discs(hfrac::Definition def, const std::vector<double>& discs) {
  def.given_discs = discs.data();
  def.given_disc_count = static_cast<int64_t>(discs.size() / 3);
  return def;
}

void expect_refused(const std::vector<double>& discs, const std::string& part) {
  const hfrac::Definition def = with_discs(cracking_def(), discs);
  hfrac_sim* sim = nullptr;
  const int32_t status = hfrac_sim_create(&def, &sim);
  EXPECT_EQ(status, HFRAC_ERR_MODEL) << last_error();
  EXPECT_EQ(sim, nullptr);
  if (status != HFRAC_OK) {
    EXPECT_NE(last_error().find(part), std::string::npos) << last_error();
  }
  hfrac_sim_destroy(&sim);
}

TEST(GivenDiscs, BuildAndStep) {
  std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
  const auto given = static_cast<int64_t>(discs.size() / 3);
  hfrac::Definition def = with_discs(cracking_def(), discs);
  def.bond_tensile_strength = def.bond_shear_strength = 15e6;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
  const Sim sim(def);
  std::fill(discs.begin(), discs.end(), 0.0);  // borrowed while it is built, no longer
  const auto setup = setup_of(sim);
  const auto state = state_of(sim);
  EXPECT_EQ(setup.packed_discs, given);
  EXPECT_DOUBLE_EQ(setup.mean_radius, 2.0);
  EXPECT_EQ(state.disc_count, given - setup.removed_in_wells - setup.removed_floaters);
  EXPECT_GT(setup.coordination, 5.0);
  EXPECT_LT(setup.coordination, 6.0);
  ASSERT_EQ(hfrac_step(sim, 2), HFRAC_OK) << last_error(sim);
  EXPECT_GT(state_of(sim).crack_count, 0);
  EXPECT_GT(well_of(sim).injected_volume, 0.0);
}

TEST(GivenDiscs, GiveTheSameTwice) {
  const std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
  hfrac::Definition def = with_discs(cracking_def(), discs);
  const Sim one(def);
  def.packing_disc_count = 12345;  // of no matter
  def.model_seed = 99;
  const Sim other(def);
  ASSERT_EQ(hfrac_step(one, 1), hfrac_step(other, 1));
  EXPECT_EQ(hash_of(one), hash_of(other));
}

TEST(GivenDiscs, OfTheEngineItselfFitAgain) {
  hfrac::Definition def = quiet_def();
  def.well_count = 0;
  const Sim packed(def);
  const auto position = doubles(packed, HFRAC_DISC_POSITION), radius = doubles(packed, HFRAC_DISC_RADIUS);
  std::vector<double> discs;
  for (std::size_t k = 0; k < radius.size(); ++k) {
    discs.insert(discs.end(), {position[2 * k], position[2 * k + 1], radius[k]});
  }
  const Sim sim(with_discs(def, discs));
  EXPECT_EQ(state_of(sim).disc_count, state_of(packed).disc_count);
  EXPECT_EQ(hfrac_step(sim, 1), HFRAC_OK);
}

TEST(GivenDiscs, ThatAreNoDiscsAreRefused) {
  for (const std::size_t member : {0u, 1u, 2u}) {
    for (const double value : {std::nan(""), HUGE_VAL}) {
      std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
      discs[3 * 17 + member] = value;
      expect_refused(discs, "given_discs[17] has a coordinate or radius that is not a finite number");
    }
  }
  for (const double radius : {0.0, -2.0}) {
    std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
    discs[3 * 17 + 2] = radius;
    expect_refused(discs, radius < 0.0 ? "given_discs[17] has radius -2 m; it must be positive"
                                       : "given_discs[17] has radius 0 m; it must be positive");
  }
  for (const double x : {-1.0, 101.0}) {
    std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
    discs[3 * 17] = x;
    expect_refused(discs, "outside the model of 100 m x 100 m");
  }
}

TEST(GivenDiscs, ThatMakeNoRockAreRefused) {
  expect_refused({50.0, 50.0, 2.0}, "given_disc_count = 1 is too few");
  std::vector<double> heap, apart;
  for (int k = 0; k < 100; ++k) {
    heap.insert(heap.end(), {50.0, 50.0, 2.0});
    apart.insert(apart.end(), {5.0 + 10.0 * (k % 10), 5.0 + 10.0 * (k / 10), 2.0});
  }
  expect_refused(heap, "");
  expect_refused(apart, "bond.gap_tolerance");
}

TEST(GivenDiscs, OnTopOfEachOtherAreRefused) {
  std::vector<double> twice = hexagonal(100.0, 100.0, 2.0);
  const std::vector<double> once = twice;
  twice.insert(twice.end(), once.begin(), once.end());
  expect_refused(twice, "overlap");
  std::vector<double> giant = once;
  giant[3 * 17 + 2] = 20.0;
  expect_refused(giant, "overlap");
  // Five times as much disc as model.
  std::vector<double> random;
  std::uint64_t seed = 1;
  const auto draw = [&] {
    seed = seed * 6364136223846793005U + 1442695040888963407U;
    return 100.0 * static_cast<double>(seed >> 11U) / 9007199254740992.0;
  };
  for (int k = 0; k < 2000; ++k) {
    const double x = draw();
    random.insert(random.end(), {x, draw(), 3.0});
  }
  expect_refused(random, "overlap");
}

// Which of them are bonded.

std::vector<int64_t> bonds_of(const hfrac_sim* sim) {
  std::vector<int64_t> bonds;
  for (const auto index : indices(const_cast<hfrac_sim*>(sim), HFRAC_BOND_DISCS)) bonds.push_back(index);
  return bonds;
}

hfrac::Definition with_bonds(hfrac::Definition def, const std::vector<int64_t>& bonds) {
  def.given_bonds = bonds.data();
  def.given_bond_count = static_cast<int64_t>(bonds.size() / 2);
  return def;
}

// A rock without a well, so that every disc given keeps its index.
hfrac::Definition plain_rock(const std::vector<double>& discs) {
  hfrac::Definition def = with_discs(quiet_def(), discs);
  def.well_count = 0;
  return def;
}

TEST(GivenBonds, AllThatAreNearAreTheSameAsNone) {
  const std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
  const Sim near(plain_rock(discs));
  const std::vector<int64_t> all = bonds_of(near);
  std::vector<int64_t> turned;  // the other way round, last first
  for (std::size_t k = all.size(); k > 0; --k) turned.push_back(all[k - 1]);
  const Sim listed(with_bonds(plain_rock(discs), turned));
  ASSERT_EQ(hfrac_step(near, 1), hfrac_step(listed, 1));
  EXPECT_EQ(hash_of(near), hash_of(listed));
}

// A line of bonds left out is a joint: it carries the far field's compression and slides or opens where bonds would hold.
TEST(GivenBonds, ThoseLeftOutAreContactsWithoutABond) {
  const std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
  const Sim whole(plain_rock(discs));
  std::vector<int64_t> kept, left_out;
  const std::vector<int64_t> all = bonds_of(whole);
  for (std::size_t k = 0; k + 1 < all.size(); k += 2) {
    const double y0 = discs[static_cast<std::size_t>(3 * all[k] + 1)];
    const double y1 = discs[static_cast<std::size_t>(3 * all[k + 1] + 1)];
    auto& to = (y0 < 50.0) == (y1 < 50.0) ? kept : left_out;
    to.insert(to.end(), {all[k], all[k + 1]});
  }
  ASSERT_GT(left_out.size(), 20u);
  const Sim jointed(with_bonds(plain_rock(discs), kept));
  EXPECT_EQ(state_of(jointed).bond_count, state_of(whole).bond_count) << "contacts stay";
  EXPECT_EQ(state_of(jointed).crack_count, state_of(whole).crack_count) << "no bond, no crack";
  const auto state = indices(jointed, HFRAC_BOND_STATE);
  const auto unbonded = std::count(state.begin(), state.end(), 3);
  EXPECT_EQ(unbonded, static_cast<std::ptrdiff_t>(left_out.size() / 2));
  const auto force = doubles(jointed, HFRAC_BOND_NORMAL_FORCE);
  double pressed = 0.0;
  for (std::size_t e = 0; e < force.size(); ++e) {
    if (state[e] != 3) continue;
    EXPECT_LE(force[e], 0.0) << "a contact does not pull";
    pressed -= force[e];
  }
  EXPECT_GT(pressed, 0.0);
  EXPECT_NE(hash_of(jointed), hash_of(whole));
  // An image knows which rock it is of.
  std::vector<unsigned char> image(1U << 24U);
  int64_t size = 0;
  ASSERT_EQ(hfrac_state_save(jointed, image.data(), static_cast<int64_t>(image.size()), &size), HFRAC_OK);
  EXPECT_EQ(hfrac_state_restore(whole, image.data(), size), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_state_restore(jointed, image.data(), size), HFRAC_OK) << last_error(jointed);
}

TEST(GivenBonds, MayBridgeAGap) {
  std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
  for (std::size_t k = 2; k < discs.size(); k += 3) discs[k] = 1.5;  // a gap of 1 m between neighbours
  const Sim touching(plain_rock(hexagonal(100.0, 100.0, 2.0)));
  const Sim bridged(with_bonds(plain_rock(discs), bonds_of(touching)));
  EXPECT_EQ(state_of(bridged).bond_count, state_of(touching).bond_count);
  EXPECT_EQ(hfrac_step(bridged, 1), HFRAC_OK) << last_error(bridged);
}

TEST(GivenBonds, OfDiscsInAWellGoWithIt) {
  const std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
  const Sim whole(plain_rock(discs));
  const std::vector<int64_t> bonds = bonds_of(whole);
  const Sim near(with_discs(cracking_def(), discs)),
      listed(with_bonds(with_discs(cracking_def(), discs), bonds));
  EXPECT_GT(setup_of(listed).removed_in_wells, 0);
  EXPECT_EQ(hash_of(listed), hash_of(near));
}

TEST(GivenBonds, ThatCannotBeAreRefused) {
  const std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
  const auto count = static_cast<int64_t>(discs.size() / 3);
  const Sim whole(plain_rock(discs));
  const std::vector<int64_t> good = bonds_of(whole);
  const auto refused = [&](std::size_t at, int64_t value, const std::string& part) {
    std::vector<int64_t> bonds = good;
    bonds[at] = value;
    const hfrac::Definition def = with_bonds(plain_rock(discs), bonds);
    hfrac_sim* sim = nullptr;
    EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_MODEL);
    EXPECT_EQ(sim, nullptr);
    EXPECT_NE(last_error().find(part), std::string::npos) << last_error();
    EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_MODEL);
  };
  for (const int64_t index : {int64_t{-1}, count, INT64_MAX, INT64_MIN})
    refused(14, index, "given_bonds[7] names disc " + std::to_string(index));
  refused(15, good[14], "to itself");
  refused(15, good[14] + count / 2 < count ? good[14] + count / 2 : good[14] - count / 2, "apart");
  std::vector<int64_t> twice = good;
  twice[14] = good[1];
  twice[15] = good[0];
  const hfrac::Definition def = with_bonds(plain_rock(discs), twice);
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_MODEL);
  EXPECT_NE(last_error().find("given_bonds[7]"), std::string::npos) << last_error();
  EXPECT_NE(last_error().find("again, after given_bonds[0]"), std::string::npos) << last_error();
}

TEST(GivenBonds, AndTheirCountMustAgree) {
  const std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
  const std::vector<int64_t> bonds = {0, 1, 1, 2};
  hfrac_sim* sim = nullptr;
  for (const int64_t count : {int64_t{0}, int64_t{-1}, INT64_MAX, INT64_MIN, int64_t{1} << 40}) {
    hfrac::Definition def = with_bonds(plain_rock(discs), bonds);
    def.given_bond_count = count;
    EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_ARGUMENT) << count;
    EXPECT_NE(last_error().find("given_bond_count"), std::string::npos) << last_error();
  }
  hfrac::Definition def = with_bonds(plain_rock(discs), bonds);
  def.given_bonds = nullptr;
  EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_ARGUMENT);
  def = with_bonds(quiet_def(), bonds);  // without discs of their own
  EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error().find("given_discs"), std::string::npos) << last_error();
}

TEST(GivenDiscs, AndTheirCountMustAgree) {
  const std::vector<double> discs = hexagonal(100.0, 100.0, 2.0);
  hfrac_sim* sim = nullptr;
  hfrac::Definition def = with_discs(cracking_def(), discs);
  def.given_discs = nullptr;
  EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(), "given_discs and given_disc_count disagree: one is set, the other is not.");
  def = with_discs(cracking_def(), discs);
  for (const int64_t count : {int64_t{0}, int64_t{-1}, INT64_MAX, INT64_MIN}) {
    def.given_disc_count = count;
    EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_ARGUMENT) << count;
  }
}

}  // namespace given_discs_test
