// SPDX-License-Identifier: BSD-3-Clause
// Misuse of every function of the interface: each argument, and each two together, of a kind no host should give; handles
// that are none or were destroyed; calls from inside callbacks and from a second thread. Whatever happens, there is a status
// of the list, a text if it is an error, and nothing has changed then. Sanitizer builds run this too.
#include "every_call.hpp"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <fstream>
#include <mutex>
#include <thread>

namespace every_call_test {

using namespace testing_capi;

int32_t stop_at_once(void*, double, const char*) {
  return 1;
}

// A small simulation with a grid, whose steps are stopped at once, and files for those that read some.
class EveryCall : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(hfrac_sim_create(&g_.def, &g_.sim), HFRAC_OK) << last_error();
    const std::string beside =
        std::string(testing::TempDir()) + "hfrac_every_call_" + std::to_string(::getpid());
    g_.case_file = beside + ".toml";
    g_.trace_file = beside + ".csv";
    g_.record_file = beside + "-record.csv";
    g_.state_file = beside + ".state";
    g_.grdecl_file = beside + ".grdecl";
    std::ofstream(g_.case_file) << "title = 'misuse'\n";
    std::ofstream(g_.record_file) << "time_s,rate_m2_s\n0,0.01\n60,0\n";
    std::ofstream(g_.trace_file) << "START_X,START_Y,END_X,END_Y\n1,1,5,5\n";
    g_.grid.struct_size = sizeof g_.grid;
    g_.grid.nx = g_.grid.ny = 2;
    g_.grid.dx = g_.grid.dy = 50.0;
    ASSERT_EQ(hfrac_set_grid(g_.sim, &g_.grid), HFRAC_OK);
    int64_t size = 0;
    ASSERT_EQ(hfrac_state_size(g_.sim, &size), HFRAC_OK);
    g_.image.resize(static_cast<std::size_t>(size));
    ASSERT_EQ(hfrac_state_save(g_.sim, g_.image.data(), size, &size), HFRAC_OK);
    ASSERT_EQ(hfrac_state_save_file(g_.sim, g_.state_file.c_str()), HFRAC_OK) << last_error(g_.sim);
    ASSERT_EQ(hfrac_field_copy_f64(g_.sim, HFRAC_DISC_RADIUS, nullptr, 0, &g_.discs), HFRAC_OK);
    ASSERT_EQ(hfrac_lab_spec_init(&g_.spec, sizeof g_.spec), HFRAC_OK);
    g_.spec.disc_count = 200;
    ASSERT_EQ(hfrac_targets_init(&g_.targets, sizeof g_.targets), HFRAC_OK);
    g_.targets.modulus = 14e9;
    g_.targets.disc_count = 200;
    g_.targets.packings = 1;
    ASSERT_EQ(hfrac_lab_run(&g_.def, &g_.spec, nullptr, nullptr, &g_.lab), HFRAC_OK) << last_error();
    good_spec_ = g_.spec;
    good_targets_ = g_.targets;
    hash_ = hash_of(g_.sim);
    good_def_ = g_.def;
    begin();
  }
  void TearDown() override {
    EXPECT_EQ(hfrac_sim_destroy(&g_.sim), HFRAC_OK);
    EXPECT_EQ(hfrac_lab_destroy(&g_.lab), HFRAC_OK);
    for (const auto& file : {g_.case_file, g_.trace_file, g_.record_file, g_.state_file, g_.grdecl_file})
      ::unlink(file.c_str());
  }

  // As at the beginning, whatever the call before did.
  void begin() {
    if (g_.made != nullptr) {
      EXPECT_EQ(hfrac_sim_destroy(&g_.made), HFRAC_OK);
    }
    EXPECT_EQ(hfrac_lab_destroy(&g_.lab_made), HFRAC_OK);
    g_.def = good_def_;
    g_.spec = good_spec_;
    g_.targets = good_targets_;
    hfrac_step_reject(g_.sim);  // refused if none is open
    EXPECT_EQ(hfrac_set_progress(g_.sim, stop_at_once, nullptr, 0.0), HFRAC_OK);
    EXPECT_EQ(hfrac_set_log(g_.sim, nullptr, nullptr, 0), HFRAC_OK);
    EXPECT_EQ(hfrac_set_on_step(g_.sim, nullptr, nullptr), HFRAC_OK);
    std::fill(g_.reals.begin(), g_.reals.end(), 30e6);
    if (hash_of(g_.sim) == hash_) return;
    EXPECT_EQ(hfrac_state_restore(g_.sim, g_.image.data(), static_cast<int64_t>(g_.image.size())), HFRAC_OK);
    EXPECT_EQ(hash_of(g_.sim), hash_);
  }

  Ground g_;
  hfrac::Definition good_def_ = quiet_def(200);
  hfrac_lab_spec good_spec_{};
  hfrac_targets good_targets_{};
  int64_t hash_ = 0;
};

bool is_known(int32_t status) {
  char text[256];
  return hfrac_status_text(status, text, sizeof text, nullptr) == HFRAC_OK;
}

TEST_F(EveryCall, IsInTheTable) {
  std::set<std::string> there, listed;
  for (const auto& row : every_call())
    EXPECT_TRUE(there.insert(row.name).second) << row.name << " is there twice";
  std::ifstream symbols(HFRAC_SYMBOLS);
  for (std::string name; symbols >> name;) listed.insert(name);
  EXPECT_FALSE(listed.empty());
  EXPECT_EQ(there, listed);
}

// Calls it with each bad argument, and each two together; `told` gets the status and the faults.
void with_bad_arguments(const Row& row, Ground& ground,
                        const std::function<void(int32_t, const std::vector<Fault>&)>& told) {
  Kept kept;
  kept.reserve(256);
  const auto bad = row.bad(kept);
  for (std::size_t one = 0; one < bad.size(); ++one) {
    told(row.call(ground, {&bad[one]}), {bad[one].fault});
    for (std::size_t two = one + 1; two < bad.size(); ++two) {
      if (bad[two].at == bad[one].at) continue;
      told(row.call(ground, {&bad[one], &bad[two]}), {bad[one].fault, bad[two].fault});
    }
  }
}

// Otherwise the bad arguments would be refused for another reason.
TEST_F(EveryCall, IsGoodWithGoodArguments) {
  for (const auto& row : every_call()) {
    if (row.name == "hfrac_step_do" || row.name == "hfrac_step_more" || row.name == "hfrac_step_finalize" ||
        row.name == "hfrac_step_reject") {
      ASSERT_EQ(hfrac_step_prepare(g_.sim), HFRAC_OK);
    }
    const int32_t status = row.good(g_);
    if (row.name == "hfrac_wall_get") {
      EXPECT_EQ(status, HFRAC_ERR_ARGUMENT) << "this model has no walls";
    } else {
      EXPECT_GE(status, 0) << row.name << ": " << last_error(row.takes_sim ? g_.sim : nullptr);
    }
    begin();
  }
}

TEST_F(EveryCall, RefusesWhatIsNoArgument) {
  for (const auto& row : every_call()) {
    const bool needs_open = row.name == "hfrac_step_do" || row.name == "hfrac_step_more";
    if (needs_open) {
      ASSERT_EQ(hfrac_step_prepare(g_.sim), HFRAC_OK);
    }
    std::size_t calls = 0;
    with_bad_arguments(row, g_, [&](int32_t status, const std::vector<Fault>& faults) {
      ++calls;
      const auto has = [&](Fault fault) { return std::count(faults.begin(), faults.end(), fault) != 0; };
      EXPECT_TRUE(is_known(status)) << row.name << " gave " << status;
      EXPECT_NE(status, HFRAC_ERR_INTERNAL) << row.name << ": " << last_error(g_.sim) << last_error();
      EXPECT_NE(status, HFRAC_ERR_POISONED) << row.name;
      // Two together may be good: a buffer NULL with a capacity of 0 asks for the size.
      const bool null_alone = faults.size() == 1 && has(Fault::null);
      // The init function sets the size; of a model without walls there is none to describe.
      const bool bad_size =
          has(Fault::size) && row.name.find("_init") == std::string::npos && row.name != "hfrac_wall_get";
      // NaN asks for the completeness of a catalogue to be found; options that are wanting are the defaults.
      const bool not_finite = has(Fault::not_finite) && row.name != "hfrac_find_magnitude_law";
      if (null_alone || has(Fault::handle) || bad_size || not_finite) {
        EXPECT_LT(status, 0) << row.name << " takes argument of kind " << static_cast<int>(faults[0]);
      }
      if (has(Fault::handle)) {
        EXPECT_EQ(status, HFRAC_ERR_BAD_HANDLE) << row.name;
      } else if (faults.size() == 1 && bad_size) {
        EXPECT_EQ(status, HFRAC_ERR_STRUCT_SIZE) << row.name;
      } else if (faults.size() == 1 && has(Fault::null)) {
        EXPECT_EQ(status, HFRAC_ERR_ARGUMENT) << row.name;
      }
      if (status < 0) {
        if (row.name != "hfrac_last_error") {
          const std::string text = last_error(row.takes_sim && !has(Fault::handle) ? g_.sim : nullptr);
          EXPECT_GT(text.size(), 10u) << row.name << " gave " << status << " without a text";
        }
        EXPECT_EQ(g_.made, nullptr) << row.name;
        if (!needs_open) {
          EXPECT_EQ(hash_of(g_.sim), hash_) << row.name << " changed the simulation and gave " << status;
        }
      }
      begin();
      if (needs_open) {
        EXPECT_EQ(hfrac_step_prepare(g_.sim), HFRAC_OK);
      }
    });
    EXPECT_GT(calls, 0u) << row.name;
    begin();
  }
}

// From inside a callback: reading is good, changing is refused.
TEST_F(EveryCall, FromACallbackIsReadingOnly) {
  struct Inside {
    Ground* ground;
    std::vector<Row> rows = every_call();
    bool done = false;
    static int32_t call(void* user, double, const char*) {
      auto& self = *static_cast<Inside*>(user);
      if (self.done) return 1;
      self.done = true;
      for (const auto& row : self.rows) {
        if (!row.takes_sim) continue;
        const int32_t status = row.good(*self.ground);
        EXPECT_EQ(status == HFRAC_ERR_BUSY, row.changes) << row.name << " gave " << status;
      }
      hfrac_sim* own = self.ground->sim;
      EXPECT_EQ(hfrac_sim_destroy(&own), HFRAC_ERR_BUSY);
      EXPECT_EQ(own, self.ground->sim);
      return 1;
    }
  } inside{&g_};
  ASSERT_EQ(hfrac_set_progress(g_.sim, Inside::call, &inside, 0.0), HFRAC_OK);
  EXPECT_EQ(hfrac_step(g_.sim, 1), HFRAC_STOPPED);
  EXPECT_TRUE(inside.done);
  EXPECT_EQ(hash_of(g_.sim), hash_);
}

// While one thread is in a call, another one's calls of the same simulation are refused, reading too.
TEST_F(EveryCall, FromASecondThreadIsRefused) {
  struct Gate {
    std::mutex mutex;
    std::condition_variable changed;
    bool inside = false, leave = false;
    static int32_t call(void* user, double, const char*) {
      auto& self = *static_cast<Gate*>(user);
      std::unique_lock lock(self.mutex);
      self.inside = true;
      self.changed.notify_all();
      self.changed.wait(lock, [&] { return self.leave; });
      return 1;
    }
  } gate;
  ASSERT_EQ(hfrac_set_progress(g_.sim, Gate::call, &gate, 0.0), HFRAC_OK);
  int32_t status = HFRAC_OK;
  std::thread other([&] { status = hfrac_step(g_.sim, 1); });
  {
    std::unique_lock lock(gate.mutex);
    gate.changed.wait(lock, [&] { return gate.inside; });
  }
  for (const auto& row : every_call()) {
    if (!row.takes_sim) continue;
    EXPECT_EQ(row.good(g_), HFRAC_ERR_BUSY) << row.name;
    if (row.name != "hfrac_last_error") {
      EXPECT_NE(last_error().find("nother thread"), std::string::npos) << row.name << ": " << last_error();
    }
  }
  hfrac_sim* own = g_.sim;
  EXPECT_EQ(hfrac_sim_destroy(&own), HFRAC_ERR_BUSY);
  EXPECT_EQ(own, g_.sim);
  {
    const std::lock_guard lock(gate.mutex);
    gate.leave = true;
    gate.changed.notify_all();
  }
  other.join();
  EXPECT_EQ(status, HFRAC_STOPPED);
  EXPECT_EQ(hash_of(g_.sim), hash_);
}

// Handles that were destroyed stay what they are, whatever is created after them.
TEST_F(EveryCall, DestroyedHandlesAreNeverReused) {
  std::vector<hfrac_sim*> gone;
  for (int k = 0; k < 5; ++k) {
    ASSERT_EQ(hfrac_sim_create(&g_.def, &g_.made), HFRAC_OK) << last_error();
    for (hfrac_sim* before : gone) {
      EXPECT_NE(before, g_.made);
      EXPECT_EQ(hfrac_step(before, 1), HFRAC_ERR_BAD_HANDLE);
      EXPECT_NE(last_error().find("destroyed"), std::string::npos);
      EXPECT_EQ(hfrac_sim_destroy(&before), HFRAC_ERR_BAD_HANDLE);
    }
    gone.push_back(g_.made);
    ASSERT_EQ(hfrac_sim_destroy(&g_.made), HFRAC_OK);
  }
}

// A view's memory stays readable while the simulation lives; its epoch says that it is of yesterday.
TEST_F(EveryCall, AStaleViewIsToldByItsEpoch) {
  const void* data = nullptr;
  int64_t count = 0, epoch = 0;
  ASSERT_EQ(hfrac_field_view(g_.sim, HFRAC_DISC_RADIUS, &data, &count, &epoch), HFRAC_OK);
  EXPECT_EQ(epoch_of(g_.sim), epoch);
  ASSERT_EQ(hfrac_set_progress(g_.sim, nullptr, nullptr, 0.0), HFRAC_OK);
  ASSERT_GE(hfrac_step(g_.sim, 1), 0);
  EXPECT_GT(epoch_of(g_.sim), epoch);
  double sum = 0.0;
  for (int64_t k = 0; k < count; ++k) sum += static_cast<const double*>(data)[k];
  EXPECT_GT(sum, 0.0);
}

// Every number of a definition or a grid, one after the other, at values no host should give.
template <class Struct, class Call>
void spoil_every_member(const Struct& good, const std::set<std::size_t>& pointers, std::size_t end,
                        Call call) {
  const int64_t integers[] = {INT64_MIN, -1, INT64_MAX, INT64_MAX / 3, 0x7ff8000000000000 /* NaN */};
  const double reals[] = {HUGE_VAL, -HUGE_VAL, -1.0, 1e308};
  for (std::size_t at = 8; at + 8 <= end; at += 8) {
    if (pointers.count(at) != 0) continue;
    const auto with = [&](const void* value) {
      Struct spoilt = good;
      std::memcpy(reinterpret_cast<unsigned char*>(&spoilt) + at, value, 8);
      const int32_t status = call(spoilt);
      EXPECT_TRUE(is_known(status) && status != HFRAC_ERR_INTERNAL) << "offset " << at << " gave " << status;
      if (status < 0) {
        EXPECT_GT(last_error().size() + 1, 10u) << "offset " << at;
      }
    };
    for (const auto value : integers) with(&value);
    for (const auto value : reals) with(&value);
  }
}

TEST_F(EveryCall, MembersOfADefinitionAreChecked) {
  const std::set<std::size_t> pointers = {
      offsetof(hfrac_sim_def, lists),       offsetof(hfrac_sim_def, wells),
      offsetof(hfrac_sim_def, joints),      offsetof(hfrac_sim_def, schedule),
      offsetof(hfrac_sim_def, given_discs), offsetof(hfrac_sim_def, progress),
      offsetof(hfrac_sim_def, log),         offsetof(hfrac_sim_def, progress_user),
      offsetof(hfrac_sim_def, log_user),    offsetof(hfrac_sim_def, given_bonds)};
  spoil_every_member(g_.def, pointers, sizeof(hfrac_sim_def), [](const hfrac_sim_def& def) {
    char text[16384];
    int32_t needed = 0;
    hfrac_sim_def_write(&def, text, sizeof text, &needed);
    return hfrac_sim_def_check(&def);
  });
}

TEST_F(EveryCall, MembersOfAGridAreChecked) {
  spoil_every_member(g_.grid, {offsetof(hfrac_grid, corners)}, sizeof(hfrac_grid),
                     [&](const hfrac_grid& grid) {
                       const int32_t status = hfrac_set_grid(g_.sim, &grid);
                       EXPECT_EQ(hash_of(g_.sim), hash_);
                       return status == HFRAC_ERR_ARGUMENT ? HFRAC_OK : status;
                     });
}

}  // namespace every_call_test
