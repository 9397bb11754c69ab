// SPDX-License-Identifier: BSD-3-Clause
// Callbacks: what a listener hears, and a look after every step that may stop the run.
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "sim_support.hpp"

namespace listening_test {

using namespace testing_capi;

struct Heard {
  int32_t level;
  std::string text;
};
struct Ear {
  std::vector<Heard> heard;
  std::function<void()> then;
  std::thread::id thread;

  static int32_t hear(void* user, int32_t level, const char* message) {
    auto& ear = *static_cast<Ear*>(user);
    ear.heard.push_back({level, message});
    ear.thread = std::this_thread::get_id();
    if (ear.then) ear.then();
    return 0;
  }
  bool has(int32_t level, const char* words) const {
    for (const auto& one : heard) {
      if (one.level == level && one.text.find(words) != std::string::npos) return true;
    }
    return false;
  }
};

TEST(Listening, HearsTheBuilding) {
  Ear ear;
  hfrac::Definition def = cracking_def();
  def.log = Ear::hear;
  def.log_user = &ear;
  const Sim sim(def);
  EXPECT_TRUE(ear.has(HFRAC_LOG_INFO, "packing the discs"));
  EXPECT_TRUE(ear.has(HFRAC_LOG_INFO, "finding equilibrium"));
  EXPECT_TRUE(ear.has(HFRAC_LOG_INFO, "discs of mean radius"));
  EXPECT_EQ(ear.thread, std::this_thread::get_id());
  for (const auto& one : ear.heard) {
    EXPECT_FALSE(one.text.empty());
    EXPECT_EQ(one.text.find('\n'), std::string::npos) << one.text;
  }
  ear.heard.clear();
  EXPECT_GE(hfrac_step(sim, 1), 0);
  EXPECT_TRUE(ear.heard.empty()) << "the definition's listener is the building's";
}

TEST(Listening, HearsWhyThereIsNoSimulation) {
  Ear ear;
  hfrac::Definition def = cracking_def();
  def.log = Ear::hear;
  def.log_user = &ear;
  def.log_level = HFRAC_LOG_ERROR;
  def.wells[0].radius = 60.0;
  hfrac_sim* sim = nullptr;
  EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_MODEL);
  ASSERT_EQ(ear.heard.size(), 1U);
  EXPECT_EQ(ear.heard[0].text, last_error());
  def.log_level = 9;
  EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_ARGUMENT);
}

TEST(Listening, LevelsAreKept) {
  const Sim sim(cracking_def());
  const auto heard_at = [&](int32_t level) {
    Ear ear;
    EXPECT_EQ(hfrac_set_log(sim, Ear::hear, &ear, level), HFRAC_OK);
    EXPECT_GE(hfrac_step(sim, 1), 0);
    EXPECT_EQ(hfrac_well_set_pressure(sim, 0, 61e6), HFRAC_OK);
    EXPECT_EQ(hfrac_step(sim, -1), HFRAC_ERR_ARGUMENT);
    EXPECT_EQ(hfrac_set_log(sim, nullptr, nullptr, 0), HFRAC_OK);
    for (const auto& one : ear.heard) EXPECT_LE(one.level, level);
    EXPECT_TRUE(ear.has(HFRAC_LOG_ERROR, "negative"));
    return ear;
  };
  EXPECT_EQ(heard_at(HFRAC_LOG_ERROR).heard.size(), 1U);
  const Ear detail = heard_at(HFRAC_LOG_DETAIL);
  EXPECT_TRUE(detail.has(HFRAC_LOG_DETAIL, "step 2"));
  EXPECT_TRUE(detail.has(HFRAC_LOG_INFO, "well 0: held at 6.1e7 Pa") ||
              detail.has(HFRAC_LOG_INFO, "well 0: held at 61000000"))
      << detail.heard.back().text;
  EXPECT_EQ(hfrac_set_log(sim, Ear::hear, nullptr, 0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_log(sim, Ear::hear, nullptr, 5), HFRAC_ERR_ARGUMENT);
}

TEST(Listening, NewCracksAreTold) {
  const Sim sim(cracking_def());
  Ear ear;
  ASSERT_EQ(hfrac_set_log(sim, Ear::hear, &ear, HFRAC_LOG_INFO), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  const std::string all = "new cracks, " + std::to_string(state_of(sim).crack_count) + " in all";
  EXPECT_TRUE(ear.has(HFRAC_LOG_INFO, all.c_str())) << all;
}

TEST(Listening, AStepThatDoesNotComeToRestIsAWarning) {
  hfrac::Definition def = cracking_def();
  def.stepping_max_cycles = 20;
  def.stepping_force_ratio = 1e-9;
  const Sim sim(def);
  Ear ear;
  ASSERT_EQ(hfrac_set_log(sim, Ear::hear, &ear, HFRAC_LOG_WARNING), HFRAC_OK);
  EXPECT_EQ(hfrac_step(sim, 1), HFRAC_NOT_AT_REST);
  EXPECT_TRUE(ear.has(HFRAC_LOG_WARNING, "did not come to rest"));
}

// A C program that takes the defaults would not learn from anything else that its fractures are too short.
TEST(Listening, ToughnessThatGrowsWithDepthIsAWarning) {
  const auto warned = [](int64_t law, double sigma) {
    hfrac::Definition def = cracking_def();
    Ear ear;
    def.stress_convention = 0;
    def.stress_sigma_Hmax = def.stress_sigma_hmin = sigma;
    def.fluid_formation_pressure = 1e6;
    def.bond_fracture_toughness = 50e6;
    def.bond_tensile_strength = def.bond_shear_strength = 1e9;
    def.wells[0].pressure = 1e6;
    def.fracture_law = law;
    if (law == 1) def.fracture_plane_modulus = 16e9;
    def.log = Ear::hear;
    def.log_user = &ear;
    def.log_level = HFRAC_LOG_WARNING;
    const Sim sim(def);
    return ear.has(HFRAC_LOG_WARNING, "times bond.fracture_toughness under this stress");
  };
  EXPECT_TRUE(warned(0, 20e6));
  EXPECT_FALSE(warned(0, 2e6));
  EXPECT_FALSE(warned(1, 20e6));
}

// Nor does it hear of its own failures, which would never end.
TEST(Listening, MayReadButNotChange) {
  const Sim sim(cracking_def());
  Ear ear;
  int64_t hash = 0;
  std::vector<int32_t> statuses;
  ear.then = [&] {
    statuses.push_back(hfrac_state_hash(sim, &hash));
    statuses.push_back(hfrac_step(sim, 1));
    statuses.push_back(hfrac_set_log(sim, nullptr, nullptr, 0));
    hfrac_sim* handle = sim;
    statuses.push_back(hfrac_sim_destroy(&handle));
  };
  ASSERT_EQ(hfrac_set_log(sim, Ear::hear, &ear, HFRAC_LOG_INFO), HFRAC_OK);
  ASSERT_EQ(hfrac_well_set_pressure(sim, 0, 50e6), HFRAC_OK);
  EXPECT_EQ(statuses, (std::vector<int32_t>{HFRAC_OK, HFRAC_ERR_BUSY, HFRAC_ERR_BUSY, HFRAC_ERR_BUSY}));
  EXPECT_EQ(ear.heard.size(), 1U);
}

TEST(Listening, WhatAListenerThrowsIsDropped) {
  const Sim sim(cracking_def());
  Ear ear;
  ear.then = [] { throw std::runtime_error("thrown by the host"); };
  ASSERT_EQ(hfrac_set_log(sim, Ear::hear, &ear, HFRAC_LOG_DETAIL), HFRAC_OK);
  EXPECT_GE(hfrac_step(sim, 1), 0);
  EXPECT_EQ(hfrac_step(sim, -1), HFRAC_ERR_ARGUMENT);
  EXPECT_GT(ear.heard.size(), 1U);
}

TEST(Listening, ChangesNoResult) {
  const Sim quiet(cracking_def()), told(cracking_def());
  Ear ear;
  ASSERT_EQ(hfrac_set_log(told, Ear::hear, &ear, HFRAC_LOG_DETAIL), HFRAC_OK);
  ASSERT_GE(hfrac_step(quiet, 2), 0);
  ASSERT_GE(hfrac_step(told, 2), 0);
  EXPECT_EQ(hash_of(quiet), hash_of(told));
}

struct Watcher {
  std::vector<int64_t> steps;
  std::vector<double> times;
  std::function<int32_t(hfrac_sim*)> look = [](hfrac_sim*) { return 0; };
  static int32_t call(void* user, hfrac_sim* sim, int64_t step, double time) {
    auto& watcher = *static_cast<Watcher*>(user);
    watcher.steps.push_back(step);
    watcher.times.push_back(time);
    return watcher.look(sim);
  }
};

TEST(OnStep, SeesEveryStepAndItsState) {
  const Sim sim(cracking_def());
  Watcher watcher;
  watcher.look = [&](hfrac_sim* seen) {
    EXPECT_EQ(seen, static_cast<hfrac_sim*>(sim));
    EXPECT_EQ(state_of(seen).step, watcher.steps.back());
    EXPECT_EQ(state_of(seen).time, watcher.times.back());
    EXPECT_FALSE(doubles(seen, HFRAC_DISC_POSITION).empty());
    EXPECT_EQ(hfrac_step(seen, 1), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_well_set_pressure(seen, 0, 1e6), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_set_on_step(seen, nullptr, nullptr), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_state_load_file(seen, "/nonexistent"), HFRAC_ERR_BUSY);
    return 0;
  };
  ASSERT_EQ(hfrac_set_on_step(sim, Watcher::call, &watcher), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 2), 0);
  double reached = 0.0;
  int32_t reason = -1;
  ASSERT_GE(hfrac_advance(sim, 3.0, &reached, &reason), 0);
  EXPECT_EQ(watcher.steps, (std::vector<int64_t>{1, 2, 3}));
  EXPECT_EQ(watcher.times, (std::vector<double>{1.0, 2.0, 3.0}));
  ASSERT_EQ(hfrac_set_on_step(sim, nullptr, nullptr), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  EXPECT_EQ(watcher.steps.size(), 3U);
}

TEST(OnStep, StopsAfterTheStepItSaw) {
  const Sim sim(cracking_def()), plain(cracking_def());
  Watcher watcher;
  watcher.look = [&](hfrac_sim*) { return watcher.steps.back() == 2 ? 1 : 0; };
  ASSERT_EQ(hfrac_set_on_step(sim, Watcher::call, &watcher), HFRAC_OK);
  EXPECT_EQ(hfrac_step(sim, 10), HFRAC_STOPPED);
  ASSERT_GE(hfrac_step(plain, 2), 0);
  EXPECT_EQ(hash_of(sim), hash_of(plain)) << "the step is kept";

  watcher.look = [&](hfrac_sim*) { return watcher.steps.back() == 4 ? 1 : 0; };
  double reached = 0.0;
  int32_t reason = -1;
  EXPECT_EQ(hfrac_advance(sim, 10.0, &reached, &reason), HFRAC_STOPPED);
  EXPECT_EQ(reached, 4.0);
  EXPECT_EQ(reason, HFRAC_REASON_CALLBACK);
  EXPECT_EQ(state_of(sim).step, 4);
}

}  // namespace listening_test
