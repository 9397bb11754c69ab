// SPDX-License-Identifier: BSD-3-Clause
// Joints, schedules and thinning fluids through the C interface: case files and keys, what they do, what is refused.
#include <cmath>
#include <cstring>

#include "../joint_def.hpp"
#include "sim_support.hpp"

namespace joint_test {

using namespace testing_capi;

hfrac_joint_def across(double x) {
  return joint_def(x, 10.0, x, 90.0, 1.0, 1.0, -1.0, HFRAC_JOINT_BONDED);
}

TEST(Joints, ReadFromACaseFileAndWrittenBack) {
  const TemporaryFolder folder;
  hfrac::Definition def = new_def();
  const char* text =
      "[[well]]\nradius = 10.0\nrate = 0.01\n[[well.schedule]]\ntime = 60\nrate = "
      "0.0\n[[well.schedule]]\ntime = 1e3\n"
      "pressure = 26e6\n[[joint]]\nx1 = 20\ny1 = 30\nx2 = 40.5\ny2 = 30\nstate = \"broken\"\nfriction = 0.6\n"
      "[[joint]]\nx1 = 1\ny1 = 2\nx2 = 3\ny2 = 4\ntensile_factor = 0.25\n";
  ASSERT_EQ(hfrac_sim_def_load(&def, folder.write(text).c_str()), HFRAC_OK) << last_error();
  ASSERT_EQ(def.joint_count, 2);
  EXPECT_EQ(def.joints[0].x2, 40.5);
  EXPECT_EQ(def.joints[0].state, HFRAC_JOINT_BROKEN);
  EXPECT_EQ(def.joints[0].tensile_factor, 1.0);
  EXPECT_EQ(def.joints[1].tensile_factor, 0.25);
  EXPECT_EQ(def.joints[1].friction, -1.0);
  ASSERT_EQ(def.schedule_count, 2);
  EXPECT_EQ(def.schedule[0].control, HFRAC_WELL_RATE);
  EXPECT_EQ(def.schedule[1].control, HFRAC_WELL_PRESSURE);
  EXPECT_EQ(def.schedule[1].value, 26e6);
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
  hfrac::Definition read = new_def();
  ASSERT_EQ(hfrac_sim_def_load(&read, folder.write(written(def)).c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(written(def), written(read));
  hfrac::Definition none = new_def();
  ASSERT_EQ(hfrac_sim_def_load(&read, folder.write(written(none)).c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(read.joint_count + read.schedule_count, 0);
}

TEST(Joints, AreSetAndReadByKey) {
  hfrac::Definition def = new_def();
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "joint[0].x1", 12.0), HFRAC_OK) << last_error();
  ASSERT_EQ(hfrac_sim_def_set_str(&def, "joint[0].state", "broken"), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "schedule[0].time", 5.0), HFRAC_OK);
  EXPECT_EQ(def.joints[0].tensile_factor, 1.0);  // the keys' default
  for (const auto& [word, state] : {std::pair{"smooth-bonded", HFRAC_JOINT_SMOOTH_BONDED},
                                    std::pair{"smooth-broken", HFRAC_JOINT_SMOOTH_BROKEN}}) {
    ASSERT_EQ(hfrac_sim_def_set_str(&def, "joint[0].state", word), HFRAC_OK) << last_error();
    EXPECT_EQ(def.joints[0].state, state);
  }
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "joint[0].state", "smooth"), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error().find("smooth-bonded"), std::string::npos) << last_error();
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "smooth_joint.normal_stiffness", 1e10), HFRAC_OK) << last_error();
  EXPECT_EQ(def.smooth_joint_normal_stiffness, 1e10);
  ASSERT_EQ(hfrac_sim_def_set_str(&def, "joint[0].state", "broken"), HFRAC_OK);
  int64_t integer = -1;
  ASSERT_EQ(hfrac_sim_def_get_i64(&def, "joint_count", &integer), HFRAC_OK);
  EXPECT_EQ(integer, 1);
  ASSERT_EQ(hfrac_sim_def_get_i64(&def, "joint[0].state", &integer), HFRAC_OK);
  EXPECT_EQ(integer, HFRAC_JOINT_BROKEN);
  ASSERT_EQ(hfrac_sim_def_get_i64(&def, "schedule_count", &integer), HFRAC_OK);
  EXPECT_EQ(integer, 1);
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "joint[2].x1", 1.0), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error().find("joints are added in order"), std::string::npos);
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "joint[0].strength", 1.0), HFRAC_ERR_UNKNOWN_KEY);
  for (const auto& [count_of, at] : {std::pair{&hfrac_joint_option_count, &hfrac_joint_option_at},
                                     std::pair{&hfrac_schedule_option_count, &hfrac_schedule_option_at}}) {
    int32_t count = 0;
    ASSERT_EQ(count_of(&count), HFRAC_OK);
    for (int32_t i = 0; i < count; ++i) {
      const auto info = read_struct<hfrac_option_info>([&](auto* to) { return at(i, to); });
      EXPECT_NE(std::strlen(info.help), 0U);
    }
    hfrac_option_info info{};
    info.struct_size = sizeof info;
    EXPECT_EQ(at(count, &info), HFRAC_ERR_ARGUMENT);
  }
  EXPECT_EQ(hfrac_joint_option_count(nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_schedule_option_count(nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_joint_option_at(0, nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_schedule_option_at(0, nullptr), HFRAC_ERR_ARGUMENT);
}

TEST(Joints, WhatMeansNothingIsRefused) {
  hfrac::Definition def = quiet_def();
  const auto refused = [&](const char* why) {
    EXPECT_LT(hfrac_sim_def_check(&def), 0) << why;
    EXPECT_NE(last_error().find(why), std::string::npos) << last_error();
    def = quiet_def();
  };
  hfrac_sim_def_set_i64(&def, "joint_count", 1);
  def.joints[0] = across(30.0);
  def.joints[0].y1 = 90.0;
  refused("has no length");
  hfrac_sim_def_set_i64(&def, "joint_count", 70);
  for (int k = 0; k < 70; ++k) def.joints[k] = across(20.0 + k);
  def.joints[66].x2 = def.joints[66].x1, def.joints[66].y2 = def.joints[66].y1;
  refused("joint[66] has no length");
  hfrac_sim_def_set_i64(&def, "schedule_count", 1);
  def.schedule[0] = {1, 0.0, 30e6, HFRAC_WELL_PRESSURE, 0};
  refused("the case has 1 wells");
  hfrac_sim_def_set_i64(&def, "schedule_count", 1);
  def.schedule[0] = {0, 0.0, 30e6, HFRAC_WELL_RAMP, 0};
  refused("a schedule");
  hfrac_sim_def_set_i64(&def, "schedule_count", 2);
  def.schedule[0] = def.schedule[1] = {0, 1.0, 30e6, HFRAC_WELL_PRESSURE, 0};
  refused("in order of time");
  def.fluid_consistency = 1.0;
  refused("Newtonian");
  def.fluid_power_index = 0.5;
  refused("needs its consistency");
  def.fluid_power_index = 0.5;
  def.fluid_consistency = 1.0;
  def.flow_scheme = 1;
  refused("flow.scheme");
}

TEST(Joints, BreakWhereTheRockWouldHold) {
  for (const int64_t solver : {0, 1}) {
    hfrac::Definition def = cracking_def(800);
    def.solver_kind = solver;
    def.wells[0].pressure = 15e6;
    const Sim whole(def);
    ASSERT_GE(hfrac_step(whole, 1), HFRAC_OK);
    EXPECT_EQ(state_of(whole).crack_count, 0);
    hfrac_sim_def_set_i64(&def, "joint_count", 1);
    def.joints[0] = joint_def(10.0, 50.0, 90.0, 50.0, 0.1, 0.1, -1.0, HFRAC_JOINT_BONDED);
    const Sim weak(def);
    ASSERT_GE(hfrac_step(weak, 1), HFRAC_OK) << last_error();
    EXPECT_GT(state_of(weak).crack_count, 2);
    for (const auto& crack : cracks_of(weak)) EXPECT_NEAR(crack.position[1], 50.0, 4.0);
    def.joints[0].state = HFRAC_JOINT_SMOOTH_BONDED;
    const Sim smooth(def);
    ASSERT_GE(hfrac_step(smooth, 1), HFRAC_OK) << last_error();
    EXPECT_GT(state_of(smooth).crack_count, 2);
    for (const auto& crack : cracks_of(smooth)) {  // drawn along the joint
      EXPECT_NEAR(crack.position[1], 50.0, 4.0);
      EXPECT_NEAR(std::abs(crack.normal[1]), 1.0, 1e-12);
    }
    def.joints[0].state = HFRAC_JOINT_BROKEN;
    const Sim broken(def);
    EXPECT_GT(state_of(broken).equilibration_cracks, 5);
    EXPECT_EQ(state_of(broken).equilibration_cracks, state_of(broken).shear_cracks);
  }
}

TEST(Schedule, StepsEndAtItsTimes) {
  hfrac::Definition def = quiet_def();
  hfrac_sim_def_set_i64(&def, "schedule_count", 3);
  def.schedule[0] = {0, 0.0, 1e-3, HFRAC_WELL_RATE, 0};
  def.schedule[1] = {0, 1.5, 0.0, HFRAC_WELL_RATE, 0};
  def.schedule[2] = {0, 2.75, 28e6, HFRAC_WELL_PRESSURE, 0};
  const Sim sim(def);
  double injected = 0.0;
  const struct {
    double time;
    int32_t control;
    double rate;
  } steps[] = {{1.0, HFRAC_WELL_RATE, 1e-3},
               {1.5, HFRAC_WELL_RATE, 1e-3},
               {2.5, HFRAC_WELL_RATE, 0.0},
               {2.75, HFRAC_WELL_RATE, 0.0},
               {3.75, HFRAC_WELL_PRESSURE, 0.0}};
  for (const auto& step : steps) {
    hfrac_step_limits limits{};
    limits.struct_size = sizeof limits;
    ASSERT_EQ(hfrac_get_step_limits(sim, &limits), HFRAC_OK);
    const double before = state_of(sim).time;
    ASSERT_GE(hfrac_step(sim, 1), HFRAC_OK);
    EXPECT_DOUBLE_EQ(state_of(sim).time, step.time);
    EXPECT_DOUBLE_EQ(limits.flow_step, step.time - before);
    EXPECT_EQ(well_of(sim).control, step.control);
    if (step.control == HFRAC_WELL_RATE) {
      injected += step.rate * (step.time - before);
      EXPECT_NEAR(well_of(sim).injected_volume, injected, 1e-15);
    }
  }
  EXPECT_EQ(well_of(sim).pressure, 28e6);
}

TEST(Schedule, OfAnOpenStepIsWhatTheHostSaidLast) {
  hfrac::Definition def = quiet_def();
  hfrac_sim_def_set_i64(&def, "schedule_count", 1);
  def.schedule[0] = {0, 0.0, 1e-3, HFRAC_WELL_RATE, 0};
  const Sim sim(def);
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  ASSERT_GE(hfrac_step_do(sim, 1.0), HFRAC_OK);
  const auto once = hash_of(sim);
  ASSERT_GE(hfrac_step_do(sim, 1.0), HFRAC_OK);
  EXPECT_EQ(hash_of(sim), once) << "a second try went another way";
  // Another schedule: the next try follows it.
  const double time[] = {0.0}, value[] = {2e-3};
  const int32_t control[] = {HFRAC_WELL_RATE};
  ASSERT_EQ(hfrac_well_set_schedule(sim, 0, 1, time, control, value), HFRAC_OK);
  ASSERT_GE(hfrac_step_do(sim, 1.0), HFRAC_OK);
  EXPECT_NEAR(well_of(sim).injected_volume, 2e-3, 1e-15);
  // A pressure ends it, for this try and for the steps that follow.
  ASSERT_EQ(hfrac_well_set_pressure(sim, 0, 28e6), HFRAC_OK);
  ASSERT_GE(hfrac_step_do(sim, 1.0), HFRAC_OK);
  EXPECT_EQ(well_of(sim).pressure, 28e6);
  ASSERT_EQ(hfrac_step_finalize(sim), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_EQ(well_of(sim).control, HFRAC_WELL_PRESSURE);
  EXPECT_EQ(well_of(sim).pressure, 28e6);
}

TEST(Schedule, IsPartOfTheState) {
  hfrac::Definition def = quiet_def();
  const Sim sim(def), other(def);
  const auto plain = hash_of(sim);
  const double time[] = {0.5, 1.0}, value[] = {29e6, 0.0};
  const int32_t control[] = {HFRAC_WELL_PRESSURE, HFRAC_WELL_RATE};
  ASSERT_EQ(hfrac_well_set_schedule(sim, 0, 2, time, control, value), HFRAC_OK) << last_error();
  EXPECT_NE(hash_of(sim), plain);
  int64_t size = 0;
  ASSERT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
  std::vector<char> image(static_cast<std::size_t>(size));
  ASSERT_EQ(hfrac_state_save(sim, image.data(), size, nullptr), HFRAC_OK) << last_error();
  ASSERT_EQ(hfrac_state_restore(other, image.data(), size), HFRAC_OK) << last_error();
  ASSERT_GE(hfrac_step(sim, 3), HFRAC_OK);
  ASSERT_GE(hfrac_step(other, 3), HFRAC_OK);
  EXPECT_EQ(hash_of(sim), hash_of(other));
  EXPECT_DOUBLE_EQ(state_of(other).time, 2.0);
  EXPECT_EQ(well_of(other).control, HFRAC_WELL_RATE);
  // Another command ends it.
  ASSERT_EQ(hfrac_well_set_pressure(other, 0, 30e6), HFRAC_OK);
  ASSERT_GE(hfrac_step(other, 1), HFRAC_OK);
  EXPECT_DOUBLE_EQ(state_of(other).time, 3.0);
  EXPECT_EQ(hfrac_well_set_schedule(sim, 0, -1, time, control, value), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_well_set_schedule(sim, 0, 1, nullptr, control, value), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_well_set_schedule(sim, 1, 2, time, control, value), HFRAC_ERR_ARGUMENT);
  const double falling[] = {1.0, 0.5}, below[] = {-1.0, 0.0};
  EXPECT_EQ(hfrac_well_set_schedule(sim, 0, 2, falling, control, value), HFRAC_ERR_ARGUMENT);
  EXPECT_LT(hfrac_well_set_schedule(sim, 0, 2, time, control, below), 0);
}

}  // namespace joint_test
