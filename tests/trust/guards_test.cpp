// SPDX-License-Identifier: BSD-3-Clause
// Numbers that go wrong stop the run at that step and say where; odd models have a stated end; nothing of ours stays behind in
// the host.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <vector>

#include "../capi/sim_support.hpp"
#include "sealed_image.hpp"

namespace {

using namespace testing_capi;
using testing_trust::image_head;

std::vector<std::uint8_t> image_of(const hfrac_sim* sim) {
  int64_t size = 0;
  EXPECT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
  std::vector<std::uint8_t> image(static_cast<std::size_t>(size));
  EXPECT_EQ(hfrac_state_save(sim, image.data(), size, &size), HFRAC_OK);
  return image;
}

// An image begins with ux, uy, rotation, vx, vy, spin of all discs, each with its count before it.
void put_disc(std::vector<std::uint8_t>& image, int array, int64_t discs, int64_t disc, double value) {
  const auto place = image_head + static_cast<std::size_t>(array * 8 * (discs + 1) + 8 + 8 * disc);
  std::memcpy(image.data() + place, &value, 8);
}
enum Array { ux = 0, vx = 3 };

TEST(Guards, ANumberThatIsNotFiniteStopsAtThatStepAndNamesTheDisc) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Sim sim(cracking_def(300));
    ASSERT_GE(hfrac_step(sim, 1), 0);
    auto image = image_of(sim);
    const int64_t discs = state_of(sim).disc_count;
    put_disc(image, vx, discs, 17, bad);
    testing_trust::seal(image);
    ASSERT_EQ(hfrac_state_restore(sim, image.data(), static_cast<int64_t>(image.size())), HFRAC_OK);
    const int64_t before = hash_of(sim);
    EXPECT_EQ(hfrac_step(sim, 5), HFRAC_ERR_DIVERGED);
    const std::string text = last_error(sim);
    EXPECT_NE(text.find("disc "), std::string::npos) << text;
    EXPECT_NE(text.find("eq. 11"), std::string::npos) << text;
    EXPECT_NE(text.find("stepping.safety"), std::string::npos) << text;
    EXPECT_EQ(hash_of(sim), before) << "the state is that before the step";
    EXPECT_EQ(state_of(sim).step, 1);
  }
}

// A NaN or an infinity in any number of the state: the image is refused, or the step stops and is undone, or the number was
// found anew and all that a host can read is finite.
TEST(Guards, NothingNotFiniteGoesOnUnseen) {
  enum Kind { substep, dynamic, quasi_static, coupled, warm };
  for (const int kind : {substep, dynamic, quasi_static, coupled, warm}) {
    hfrac::Definition def = cracking_def(60);
    def.wells[0].radius = 20.0;
    def.stepping_max_cycles = 200;
    def.stepping_flow_step = kind == dynamic ? 1e-3 : 1e-2;
    def.stepping_mode = kind == dynamic ? 1 : (kind == coupled ? 2 : 0);
    def.solver_kind = kind == quasi_static || kind == coupled ? 1 : 0;
    def.thermal_mode = kind == warm ? 2 : 0;
    if (kind == substep)
      def.stress_sigma_Hmax = def.stress_sigma_hmin = 5e6;  // so that the balance begins with something
    const Sim sim(def);
    ASSERT_GE(hfrac_step(sim, 2), 0) << last_error(sim);
    const auto good = image_of(sim);
    int stopped = 0, refused = 0;
    // Byte by byte, since some members are single bytes and numbers begin anywhere.
    for (std::size_t place = image_head, turn = 0; place + 8 <= good.size(); ++place, ++turn) {
      double value = 0.0;
      std::memcpy(&value, good.data() + place, 8);
      if (!(std::abs(value) > 1e-30 && std::abs(value) < 1e15))
        continue;  // zero, or no real number begins here
      value = turn % 2 == 0 ? std::nan("") : std::numeric_limits<double>::infinity();
      auto image = good;
      std::memcpy(image.data() + place, &value, 8);
      testing_trust::seal(image);
      const int32_t restored = hfrac_state_restore(sim, image.data(), static_cast<int64_t>(image.size()));
      ASSERT_TRUE(restored == HFRAC_OK || restored == HFRAC_ERR_ARGUMENT) << kind << " " << place;
      if (restored != HFRAC_OK) {
        ++refused;
        continue;
      }
      const int64_t before = hash_of(sim);
      const int32_t status = hfrac_step(sim, 1);
      if (status < 0) {
        ++stopped;
        // A finite number that means nothing throws discs about.
        ASSERT_TRUE(status == HFRAC_ERR_DIVERGED || status == HFRAC_ERR_COLLAPSED)
            << kind << " " << place << ": " << last_error(sim);
        ASSERT_EQ(hash_of(sim), before) << kind << " " << place;
        ASSERT_NE(last_error(sim).find("; "), std::string::npos) << "no hint: " << last_error(sim);
      } else {
        for (const int32_t field : {HFRAC_DISC_POSITION, HFRAC_DISC_DISPLACEMENT, HFRAC_DISC_VELOCITY,
                                    HFRAC_DOMAIN_PRESSURE, HFRAC_PIPE_APERTURE, HFRAC_PIPE_FLOW}) {
          for (const double number : doubles(sim, field))
            ASSERT_TRUE(std::isfinite(number)) << kind << " " << place;
        }
        const auto balance = balance_of(sim);
        ASSERT_EQ(std::isfinite(balance.energy_error), balance.energy_checked != 0) << kind << " " << place;
        ASSERT_TRUE(std::isfinite(balance.damping) && std::isfinite(balance.fluid_error))
            << kind << " " << place;
      }
      ASSERT_EQ(hfrac_state_restore(sim, good.data(), static_cast<int64_t>(good.size())), HFRAC_OK);
    }
    EXPECT_GT(stopped, 20) << kind;
    if (kind == substep) {
      EXPECT_GT(refused, 5) << kind;
    }
  }
}

// What an unstable step would do: motion that no work brought in.
TEST(Guards, EnergyFromNowhereIsCaughtInItsStep) {
  hfrac::Definition def = quiet_def(300);
  def.stepping_mode = 1;
  def.stepping_flow_step = 1e-3;
  def.stepping_damping = 0.0;
  const Sim sim(def);
  ASSERT_GE(hfrac_step(sim, 3), 0) << last_error(sim);
  const auto good = image_of(sim);
  auto image = good;
  const int64_t discs = state_of(sim).disc_count;
  for (int64_t i = 0; i < discs; ++i) put_disc(image, vx, discs, i, i % 2 == 0 ? 300.0 : -300.0);
  testing_trust::seal(image);
  ASSERT_EQ(hfrac_state_restore(sim, image.data(), static_cast<int64_t>(image.size())), HFRAC_OK);
  EXPECT_EQ(hfrac_step(sim, 1), HFRAC_ERR_DIVERGED);
  EXPECT_NE(last_error(sim).find("no work accounts for"), std::string::npos) << last_error(sim);
  EXPECT_NE(last_error(sim).find("disc "), std::string::npos) << last_error(sim);
  EXPECT_EQ(state_of(sim).step, 3);
  ASSERT_EQ(hfrac_state_restore(sim, good.data(), static_cast<int64_t>(good.size())), HFRAC_OK);
  EXPECT_GE(hfrac_step(sim, 3), 0) << "a sound state goes on";
}

TEST(Guards, IndicesInAnImageAreChecked) {
  const Sim sim(cracking_def(300));
  ASSERT_GE(hfrac_step(sim, 2), 0);
  ASSERT_GT(state_of(sim).crack_count, 0);
  const auto good = image_of(sim);
  const int64_t before = hash_of(sim);
  // Every number that could be a bond, a disc or a domain is made one that is none; some are plain values and pass.
  int refused = 0;
  for (std::size_t place = image_head; place + 8 <= good.size(); place += 4) {
    std::int32_t number = 0;
    std::memcpy(&number, good.data() + place, 4);
    if (number <= 0 || number > 5000) continue;
    auto image = good;
    const std::int32_t none = 1000000;
    std::memcpy(image.data() + place, &none, 4);
    testing_trust::seal(image);
    const int32_t status = hfrac_state_restore(sim, image.data(), static_cast<int64_t>(image.size()));
    ASSERT_TRUE(status == HFRAC_OK || status == HFRAC_ERR_ARGUMENT) << place;
    if (status != HFRAC_OK) {
      ++refused;
      ASSERT_EQ(hash_of(sim), before) << place;
    }
    ASSERT_EQ(hfrac_state_restore(sim, good.data(), static_cast<int64_t>(good.size())), HFRAC_OK);
  }
  EXPECT_GT(refused, 20);
}

TEST(OddModels, AFractureThatReachesTheBoundaryIsToldAndNothingBreaksDown) {
  hfrac::Definition def = cracking_def(400);
  def.wells[0].pressure = 100e6;
  def.stop_extent_fraction = 0.3;
  const Sim sim(def);
  double reached = 0.0;
  int32_t reason = 0;
  ASSERT_GE(hfrac_advance(sim, 40.0, &reached, &reason), 0) << last_error(sim);
  ASSERT_EQ(reason, HFRAC_REASON_EXTENT);
  EXPECT_EQ(state_of(sim).stop_reason, HFRAC_REASON_EXTENT);
  EXPECT_GE(hfrac_step(sim, 3), 0) << "a host that goes on all the same may: " << last_error(sim);
  EXPECT_LT(std::abs(balance_of(sim).fluid_error), 1e-9 * std::abs(balance_of(sim).injected_volume) + 1e-12);
}

// A hundred times the strength in compression and in tension: what is open is never less than nothing.
TEST(OddModels, AperturesAreNeverNegative) {
  for (const double far_field : {0.0, 500e6}) {
    hfrac::Definition def = quiet_def(400);
    def.stress_convention = 1;
    def.fluid_formation_pressure = 0.0;
    def.stress_sigma_Hmax = def.stress_sigma_hmin = far_field;
    def.wells[0].pressure = 300e6;
    def.flow_bonded_gap_factor = 1.0;
    const Sim sim(def);
    ASSERT_GE(hfrac_step(sim, 3), 0) << last_error(sim);
    const auto aperture = doubles(sim, HFRAC_PIPE_APERTURE);
    EXPECT_GE(*std::min_element(aperture.begin(), aperture.end()), 0.0);
    for (const auto& crack : cracks_of(sim)) EXPECT_GE(crack.aperture, 0.0);
  }
}

// Rock that lets nothing through: pores are alone, keep what they hold, and the balance closes.
TEST(OddModels, IsolatedPoresKeepTheirFluid) {
  for (const int64_t solver : {1, 2}) {
    hfrac::Definition def = quiet_def(300);
    def.flow_permeability = 1e-30;
    def.flow_outer = 1;
    def.flow_solver = solver;
    def.wells[0].pressure = 60e6;
    const Sim sim(def);
    ASSERT_GE(hfrac_step(sim, 3), 0) << last_error(sim);
    const auto balance = balance_of(sim);
    EXPECT_EQ(balance.leaked_volume, 0.0);
    EXPECT_LT(std::abs(balance.fluid_error), 1e-12);
    for (const double p : doubles(sim, HFRAC_DOMAIN_PRESSURE)) ASSERT_TRUE(std::isfinite(p));
  }
}

std::vector<double> lattice(double left, int across, int up, double radius) {
  std::vector<double> discs;
  for (int j = 0; j < up; ++j) {
    for (int i = 0; i < across; ++i)
      discs.insert(discs.end(), {left + radius * (1 + 2 * i + j % 2), radius * (1 + 1.7320508 * j), radius});
  }
  return discs;
}

hfrac::Definition given_def(const std::vector<double>& discs) {
  hfrac::Definition def = cracking_def();
  def.boundary_kind = 0;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 1e6;
  def.well_count = 0;
  def.given_discs = discs.data();
  def.given_disc_count = static_cast<int64_t>(discs.size() / 3);
  return def;
}

TEST(OddModels, DiscsThatOverlapAreRefusedByName) {
  auto discs = lattice(0.0, 9, 11, 5.0);
  discs.insert(discs.end(), {46.0, 40.0, 5.0});
  const hfrac::Definition def = given_def(discs);
  hfrac_sim* sim = nullptr;
  EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_MODEL);
  EXPECT_NE(last_error().find("overlap"), std::string::npos) << last_error();
  EXPECT_EQ(sim, nullptr);
}

// Two pieces that do not touch: a model that is built, but cannot be held together by a far field, says so as a status or
// comes to rest; never a crash, never a number that is not finite.
TEST(OddModels, SeparatePiecesEndWithAStatus) {
  auto discs = lattice(0.0, 4, 11, 5.0);
  const auto other = lattice(52.0, 4, 11, 5.0);
  discs.insert(discs.end(), other.begin(), other.end());
  const hfrac::Definition def = given_def(discs);
  hfrac_sim* sim = nullptr;
  ASSERT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK) << last_error();
  EXPECT_GE(hfrac_step(sim, 2), 0) << last_error(sim);
  for (const double x : doubles(sim, HFRAC_DISC_POSITION)) ASSERT_TRUE(std::isfinite(x));
  hfrac_sim_destroy(&sim);
}

std::size_t threads_now() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& task : std::filesystem::directory_iterator("/proc/self/task")) ++count;
  return count;
}

TEST(Host, NoThreadStaysBehind) {
  const std::size_t before = threads_now();
  for (int round = 0; round < 3; ++round) {
    hfrac::Definition def = quiet_def(100);
    def.wells[0].radius = 20.0;
    def.run_workers = 8;
    def.packing_residual = def.stepping_force_ratio = 1e-2;
    def.stepping_max_cycles = 40;
    const Sim sim(def);
    EXPECT_EQ(threads_now(), before + 7);
    ASSERT_GE(hfrac_step(sim, 1), 0);
  }
  EXPECT_EQ(threads_now(), before);
  hfrac::Definition bad = quiet_def(300);
  bad.run_workers = 8;
  bad.wells[0].x = -5.0;
  hfrac_sim* sim = nullptr;
  EXPECT_LT(hfrac_sim_create(&bad, &sim), 0);
  EXPECT_EQ(threads_now(), before);
}

}  // namespace
