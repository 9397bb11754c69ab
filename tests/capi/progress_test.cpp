// SPDX-License-Identifier: BSD-3-Clause
// The progress callback: when it is called, what it may do, and that stopping leaves no trace.
#include <limits>
#include <thread>

#include "sim_support.hpp"

namespace progress_test {

using namespace testing_capi;

TEST(Progress, RunsThroughTheBuilding) {
  hfrac::Definition def = quiet_def(1500);
  def.packing_residual = 1e-6;  // long enough to be asked
  double last = -1.0;
  int calls = 0;
  const auto caller = std::this_thread::get_id();
  Host host([&](double fraction, const char* what) {
    ++calls;
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.0);
    EXPECT_NE(what, nullptr);
    EXPECT_EQ(std::this_thread::get_id(), caller);
    last = fraction;
    return 0;
  });
  def.progress = host.call;
  def.progress_user = &host;
  const Sim sim(def);
  EXPECT_GT(calls, 0);
  // That callback was for the building only.
  const int before = calls;
  ASSERT_EQ(hfrac_step(sim, 2), HFRAC_OK);
  EXPECT_EQ(calls, before);
}

TEST(Progress, StopsTheBuilding) {
  hfrac::Definition def = quiet_def(20000);
  int calls = 0;
  Host host([&](double, const char*) { return ++calls; });
  def.progress = host.call;
  def.progress_user = &host;
  hfrac_sim* sim = nullptr;
  EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_STOPPED);
  EXPECT_EQ(sim, nullptr);
  EXPECT_EQ(calls, 1);
}

TEST(Progress, IsCalledOnTheCallersThreadAsOftenAsAsked) {
  const Sim sim(cracking_def());
  int calls = 0;
  double last = -1.0;
  const auto caller = std::this_thread::get_id();
  Host host([&](double fraction, const char* what) {
    ++calls;
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.0);
    EXPECT_STRNE(what, "");
    EXPECT_EQ(std::this_thread::get_id(), caller);
    last = fraction;
    return 0;
  });
  host.attach(sim);
  ASSERT_EQ(hfrac_step(sim, 2), HFRAC_OK);
  EXPECT_GT(calls, 2);
  double reached = 0.0;
  int32_t reason = -1;
  last = -1.0;
  ASSERT_EQ(hfrac_advance(sim, 4.0, &reached, &reason), HFRAC_OK);
  EXPECT_GT(last, 0.4);
  // Seldom, and not at all.
  calls = 0;
  host.attach(sim, 3600.0);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_EQ(calls, 0);
  host.attach(sim);
  ASSERT_EQ(hfrac_set_progress(sim, nullptr, nullptr, 0.0), HFRAC_OK);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_EQ(calls, 0);
}

TEST(Progress, StoppingAStepLeavesNoTrace) {
  const Sim sim(cracking_def()), twin(cracking_def());
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  ASSERT_EQ(hfrac_step(twin, 1), HFRAC_OK);
  // Higher pressure: much breaks in the step that is stopped, and the fluid takes another number of rounds.
  ASSERT_EQ(hfrac_well_set_pressure(sim, 0, 120e6), HFRAC_OK);
  ASSERT_EQ(hfrac_well_set_pressure(twin, 0, 120e6), HFRAC_OK);
  const Sight before = sight_of(sim);
  for (const int patience : {1, 2, 4, 8}) {
    int calls = 0;
    Host host([&](double, const char*) { return ++calls >= patience ? 7 : 0; });
    host.attach(sim);
    ASSERT_EQ(hfrac_step(sim, 1), HFRAC_STOPPED) << patience;
    EXPECT_EQ(calls, patience);  // not asked again
    expect_same(sight_of(sim), before);
    ASSERT_EQ(hfrac_set_progress(sim, nullptr, nullptr, 0.0), HFRAC_OK);
  }
  for (int k = 0; k < 2; ++k) {
    ASSERT_EQ(hfrac_step(sim, 1), hfrac_step(twin, 1));
    expect_same(sight_of(sim), sight_of(twin));
  }
}

TEST(Progress, StoppingKeepsTheStepsBefore) {
  const Sim sim(cracking_def());
  Host host([&](double fraction, const char*) { return fraction > 0.45 ? 1 : 0; });
  host.attach(sim);
  EXPECT_EQ(hfrac_step(sim, 4), HFRAC_STOPPED);
  EXPECT_EQ(state_of(sim).step, 2);
  double reached = 0.0;
  int32_t reason = -1;
  EXPECT_EQ(hfrac_advance(sim, 6.0, &reached, &reason), HFRAC_STOPPED);
  EXPECT_EQ(reason, HFRAC_REASON_CALLBACK);
  EXPECT_EQ(reached, 4.0);
  EXPECT_EQ(state_of(sim).step, 4);
}

TEST(Progress, MayReadAndNotChange) {
  const Sim sim(cracking_def()), twin(cracking_def());
  int calls = 0;
  Host host([&](double, const char*) {
    ++calls;
    int64_t count = 0, number = 0;
    int32_t wells = 0;
    double reached = 0.0;
    const void* data = nullptr;
    hfrac::Definition def = new_def();
    // Reading works.
    sight_of(sim);
    fractures_of(sim);
    setup_of(sim);
    EXPECT_EQ(hfrac_sim_definition(sim, &def), HFRAC_OK);
    EXPECT_EQ(hfrac_well_count(sim, &wells), HFRAC_OK);
    EXPECT_EQ(hfrac_field_view(sim, HFRAC_DISC_RADIUS, &data, &count, &number), HFRAC_OK);
    EXPECT_EQ(number, epoch_of(sim));
    EXPECT_EQ(hfrac_state_size(sim, &number), HFRAC_OK);
    // Changing does not, and says so.
    EXPECT_EQ(hfrac_step(sim, 1), HFRAC_ERR_BUSY);
    EXPECT_NE(last_error(sim).find("inside its own callback"), std::string::npos);
    EXPECT_EQ(hfrac_advance(sim, 9.0, &reached, &wells), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_set_progress(sim, nullptr, nullptr, 0.0), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_well_set_pressure(sim, 0, 1e6), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_well_set_ramp(sim, 0, 1e6, 1e6), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_well_set_rate(sim, 0, 1.0), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_step_prepare(sim), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_step_do(sim, 1.0), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_step_finalize(sim), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_step_reject(sim), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_state_restore(sim, &reached, sizeof reached), HFRAC_ERR_BUSY);
    EXPECT_EQ(hfrac_set_far_field(sim, 0.0, 0.0), HFRAC_ERR_BUSY);
    hfrac_sim* self = sim;
    EXPECT_EQ(hfrac_sim_destroy(&self), HFRAC_ERR_BUSY);
    EXPECT_EQ(self, sim);
    return 0;
  });
  host.attach(sim);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_GT(calls, 2);
  ASSERT_EQ(hfrac_step(twin, 1), HFRAC_OK);
  EXPECT_EQ(hash_of(sim), hash_of(twin));
  EXPECT_EQ(hfrac_set_progress(sim, nullptr, nullptr, 0.0), HFRAC_OK);
}

TEST(Progress, OtherSimulationsMayBeUsedInside) {
  const Sim sim(cracking_def()), other(quiet_def()), alone(quiet_def());
  int calls = 0;
  Host host([&](double, const char*) {
    if (++calls <= 2) {
      EXPECT_EQ(hfrac_step(other, 1), HFRAC_OK);
    }
    return 0;
  });
  host.attach(sim);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  ASSERT_EQ(hfrac_step(alone, 2), HFRAC_OK);
  EXPECT_EQ(hash_of(other), hash_of(alone));
}

TEST(Progress, ViewsTakenInsideDoNotOutliveTheStep) {
  const Sim sim(cracking_def());
  Host host([&](double, const char*) {
    const void* data = nullptr;
    int64_t count = 0, epoch = 0;
    EXPECT_EQ(hfrac_field_view(sim, HFRAC_DISC_POSITION, &data, &count, &epoch), HFRAC_OK);
    return 0;
  });
  host.attach(sim);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  const void* data = nullptr;
  int64_t count = 0, epoch = 0;
  ASSERT_EQ(hfrac_field_view(sim, HFRAC_DISC_POSITION, &data, &count, &epoch), HFRAC_OK);
  const auto* viewed = static_cast<const double*>(data);
  EXPECT_TRUE(std::vector<double>(viewed, viewed + count) == doubles(sim, HFRAC_DISC_POSITION))
      << "the view shows the middle of the step";
}

TEST(Progress, RefusesWhatIsNoInterval) {
  const Sim sim(quiet_def());
  EXPECT_EQ(hfrac_set_progress(sim, nullptr, nullptr, std::numeric_limits<double>::quiet_NaN()),
            HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("seconds"), std::string::npos);
}

}  // namespace progress_test
