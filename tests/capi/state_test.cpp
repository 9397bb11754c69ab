// SPDX-License-Identifier: BSD-3-Clause
// Images of the state, and steps that are tried, rejected and tried again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim_support.hpp"

namespace state_test {

using namespace testing_capi;

hfrac::Definition ramped_def() {
  hfrac::Definition def = new_def();
  def.model_width = def.model_height = 40.0;
  def.packing_disc_count = 700;
  def.packing_residual = 1e-3;
  def.stepping_flow_step = 1e-2;
  def.stress_sigma_Hmax = 30e6;
  def.stress_sigma_hmin = 26e6;
  hfrac_sim_def_set_i64(&def, "well_count", 1);
  hfrac_well_def& well = def.wells[0];
  well.x = well.y = 20.0;
  well.radius = 4.0;
  well.pressure = 75e6;
  well.ramp_per_step = 8e6;
  well.control = HFRAC_WELL_RAMP;
  return def;
}

std::vector<unsigned char> image_of(const hfrac_sim* sim) {
  std::int64_t size = 0;
  EXPECT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
  std::vector<unsigned char> image(static_cast<std::size_t>(size));
  EXPECT_EQ(hfrac_state_save(sim, image.data(), size, &size), HFRAC_OK) << last_error(sim);
  return image;
}

void restore_then_run_equals_run(const hfrac_sim_def& def) {
  Sim sim(def);
  ASSERT_GE(hfrac_step(sim, 5), 0);
  const auto image = image_of(sim);
  ASSERT_GE(hfrac_step(sim, 6), 0);
  const auto end = hash_of(sim);
  EXPECT_GT(state_of(sim).crack_count, 0) << "the case must break something to be worth the test";
  ASSERT_EQ(hfrac_state_restore(sim, image.data(), static_cast<std::int64_t>(image.size())), HFRAC_OK);
  EXPECT_NE(hash_of(sim), end);
  ASSERT_GE(hfrac_step(sim, 6), 0);
  EXPECT_EQ(hash_of(sim), end);

  Sim other(def);  // as another process would: same definition, image from elsewhere
  ASSERT_EQ(hfrac_state_restore(other, image.data(), static_cast<std::int64_t>(image.size())), HFRAC_OK);
  ASSERT_GE(hfrac_step(other, 6), 0);
  EXPECT_EQ(hash_of(other), end);
}

TEST(State, RestoreThenRunEqualsRun) {
  restore_then_run_equals_run(ramped_def());
}

TEST(State, RestoreThenRunEqualsRunQuasiStatic) {
  hfrac::Definition def = ramped_def();
  def.solver_kind = 1;  // reads the bonds one by one
  restore_then_run_equals_run(def);
}

TEST(State, RefusedImagesChangeNothing) {
  Sim sim(ramped_def());
  ASSERT_GE(hfrac_step(sim, 2), 0);
  auto image = image_of(sim);
  const auto before = hash_of(sim);
  const auto refused = [&](const std::vector<unsigned char>& bytes) {
    EXPECT_EQ(hfrac_state_restore(sim, bytes.data(), static_cast<std::int64_t>(bytes.size())),
              HFRAC_ERR_ARGUMENT);
    EXPECT_FALSE(last_error(sim).empty());
    EXPECT_EQ(hash_of(sim), before);
  };
  auto damaged = image;
  damaged[damaged.size() / 2] ^= 1U;
  refused(damaged);
  auto cut = image;
  cut.resize(cut.size() - 9);
  refused(cut);
  refused({1, 2, 3});
  auto foreign = image;
  foreign[0] = 'x';
  refused(foreign);
  hfrac::Definition def = ramped_def();
  def.model_seed = 2;
  Sim other(def);
  refused(image_of(other));
  std::int64_t size = 0;
  EXPECT_EQ(hfrac_state_save(sim, image.data(), 10, &size), HFRAC_ERR_ARGUMENT);
}

TEST(OpenStep, TriesStartFromTheSamePlace) {
  Sim sim(ramped_def()), plain(ramped_def());
  ASSERT_GE(hfrac_step(sim, 3), 0);
  ASSERT_GE(hfrac_step(plain, 3), 0);
  const auto start = hash_of(sim);
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  EXPECT_EQ(hfrac_step(sim, 1), HFRAC_ERR_ARGUMENT) << "a step is open";
  ASSERT_GE(hfrac_step_do(sim, 5.0), 0);
  ASSERT_GE(hfrac_step_do(sim, 1e-2), 0);
  ASSERT_EQ(hfrac_step_finalize(sim), HFRAC_OK);
  ASSERT_GE(hfrac_step(plain, 1), 0);
  EXPECT_EQ(hash_of(sim), hash_of(plain)) << "the accepted try is a plain step of that length";

  ASSERT_EQ(hfrac_step_prepare(plain), HFRAC_OK);
  ASSERT_EQ(hfrac_well_set_pressure(plain, 0, 75e6), HFRAC_OK);
  ASSERT_GE(hfrac_step_do(plain, 1.0), 0);
  ASSERT_EQ(hfrac_step_reject(plain), HFRAC_OK);
  EXPECT_EQ(hash_of(sim), hash_of(plain)) << "rejected: as if nothing had been";
  EXPECT_NE(hash_of(plain), start);

  EXPECT_EQ(hfrac_step_do(sim, 1.0), HFRAC_ERR_ARGUMENT) << "no step is open";
  EXPECT_EQ(hfrac_step_finalize(sim), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_step_reject(sim), HFRAC_ERR_ARGUMENT);
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  EXPECT_EQ(hfrac_step_do(sim, -1.0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_step_prepare(sim), HFRAC_ERR_ARGUMENT);
}

TEST(OpenStep, HoldsSeveralStepsThatAreRejectedAsOne) {
  Sim sim(ramped_def()), plain(ramped_def());
  const auto start = hash_of(sim);
  EXPECT_EQ(hfrac_step_more(sim, 1e-2), HFRAC_ERR_ARGUMENT) << "no step is open";
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  ASSERT_GE(hfrac_step_do(sim, 1e-2), 0);
  ASSERT_GE(hfrac_step_more(sim, 1e-2), 0);
  EXPECT_EQ(hfrac_step_more(sim, 0.0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(state_of(sim).step, 2);
  ASSERT_EQ(hfrac_step_reject(sim), HFRAC_OK);
  EXPECT_EQ(hash_of(sim), start);
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  for (int round = 0; round < 2; ++round) {
    ASSERT_GE(hfrac_step_do(sim, 1e-2), 0);
    ASSERT_GE(hfrac_step_more(sim, 1e-2), 0);
  }
  ASSERT_EQ(hfrac_step_finalize(sim), HFRAC_OK);
  ASSERT_GE(hfrac_step(plain, 2), 0);
  EXPECT_EQ(hash_of(sim), hash_of(plain));
}

TEST(FarField, MoreStressPressesTheModelTogether) {
  Sim sim(ramped_def());
  const auto width = [&] {
    const auto position = doubles(sim, HFRAC_DISC_POSITION);
    double low = 1e300, high = -1e300;
    for (std::size_t k = 0; k < position.size(); k += 2) {
      low = std::min(low, position[k]);
      high = std::max(high, position[k]);
    }
    return high - low;
  };
  const double before = width();
  ASSERT_EQ(hfrac_well_set_pressure(sim, 0, 25e6), HFRAC_OK);
  ASSERT_EQ(hfrac_set_far_field(sim, 45e6, 26e6), HFRAC_OK) << last_error(sim);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  EXPECT_LT(width(), before);
  const hfrac_balance balance = balance_of(sim);
  EXPECT_GT(balance.boundary_work, 0.0);
  EXPECT_LT(std::abs(balance.energy_error), 1e-2 * balance.boundary_work);
  EXPECT_EQ(hfrac_set_far_field(sim, 10e6, 20e6), HFRAC_ERR_ARGUMENT);

  hfrac::Definition def = ramped_def();
  def.boundary_kind = 1;  // walls, fixed after set-up
  Sim walled(def);
  EXPECT_EQ(hfrac_set_far_field(walled, 45e6, 26e6), HFRAC_ERR_ARGUMENT);
}

}  // namespace state_test
