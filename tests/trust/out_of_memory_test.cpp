// SPDX-License-Identifier: BSD-3-Clause
// Memory runs out at every single request the library makes: the call says so, nothing crashes or leaks, and what was there
// before is as it was.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "../capi/sim_support.hpp"
#include "failing_memory.hpp"

namespace {

using namespace testing_capi;

hfrac::Definition small_def(int64_t workers = 1) {
  hfrac::Definition def = cracking_def(60);
  def.wells[0].radius = 20.0;
  def.run_workers = workers;
  return def;
}
hfrac::Definition quasi_static_def() {
  hfrac::Definition def = small_def();
  def.solver_kind = 1;
  def.stepping_mode = 2;
  def.stepping_flow_step = 1e-2;
  return def;
}

// Requests to fail at, of unknown number: the first 1 200 one by one, then ever farther apart.
long next_place(long place) {
  return place < 1200 ? place + 1 : place + place / 40;
}

// Calls `call` again and again, with memory running out ever later, until it gets through. `prepare` before and `look` after
// each try, with memory at hand. Gives how often it ran out.
int run_out_everywhere(bool lasting, const std::function<void()>& prepare,
                       const std::function<int32_t()>& call, const std::function<void(int32_t, long)>& look) {
  int times = 0;
  for (long place = 0;; place = next_place(place)) {
    prepare();
    failing_memory::refuse_after(place, lasting);
    const int32_t status = call();
    const bool ran_out = failing_memory::stop_refusing();
    look(status, place);
    if (testing::Test::HasFatalFailure()) return times;
    if (!ran_out) {
      EXPECT_GE(status, 0) << last_error();
      return times;
    }
    ++times;
  }
}

TEST(OutOfMemory, CreateGivesAStatusAndLeaksNothing) {
  for (const int64_t workers : {1, 3}) {
    for (const bool lasting : {false, true}) {
      const hfrac::Definition def = small_def(workers);
      hfrac_sim* sim = nullptr;
      long before = 0;
      const int times = run_out_everywhere(
          lasting, [&] { before = failing_memory::outstanding(); },
          [&] { return hfrac_sim_create(&def, &sim); },
          [&](int32_t status, long place) {
            ASSERT_TRUE(status == HFRAC_OK || status == HFRAC_ERR_MEMORY) << place << " " << last_error();
            ASSERT_EQ(sim == nullptr, status != HFRAC_OK) << place;
            if (status != HFRAC_OK) {
              ASSERT_FALSE(last_error().empty());
            }
            ASSERT_EQ(hfrac_sim_destroy(&sim), HFRAC_OK);
            // The C library keeps what belongs to ended threads.
            if (workers == 1) {
              ASSERT_EQ(failing_memory::outstanding(), before) << place;
            }
          });
      EXPECT_GT(times, 300);
    }
  }
}

// A step that ran out leaves a simulation that may be unusable, but says so; what was saved before is good, and so is every
// other simulation.
TEST(OutOfMemory, AStepGivesAStatusAndEarlierResultsStand) {
  for (const hfrac_sim_def& def : {small_def(), small_def(2), quasi_static_def()}) {
    const Sim witness(def);
    ASSERT_GE(hfrac_step(witness, 1), 0) << last_error(witness);
    int64_t size = 0;
    ASSERT_EQ(hfrac_state_size(witness, &size), HFRAC_OK);
    std::vector<char> image(static_cast<std::size_t>(size));
    ASSERT_EQ(hfrac_state_save(witness, image.data(), size, &size), HFRAC_OK);
    const int64_t before = hash_of(witness);
    int64_t after = 0;
    {
      const Sim other(def);
      ASSERT_GE(hfrac_step(other, 2), 0);
      after = hash_of(other);
    }
    hfrac_sim* sim = nullptr;
    const int times = run_out_everywhere(
        false,
        [&] {
          if (sim == nullptr) {
            ASSERT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK) << last_error();
            ASSERT_EQ(hfrac_state_restore(sim, image.data(), size), HFRAC_OK) << last_error(sim);
          }
        },
        [&] { return hfrac_step(sim, 1); },
        [&](int32_t status, long place) {
          if (status >= 0) {
            ASSERT_EQ(hash_of(sim), after) << "a good status, another result: request " << place;
          } else {
            ASSERT_EQ(status, HFRAC_ERR_MEMORY) << place << ": " << last_error(sim);
            ASSERT_EQ(hfrac_step(sim, 1), HFRAC_ERR_POISONED) << place;
          }
          ASSERT_EQ(hfrac_sim_destroy(&sim), HFRAC_OK);
        });
    EXPECT_GT(times, 3);
    hfrac_sim_destroy(&sim);
    EXPECT_EQ(hash_of(witness), before);
    EXPECT_GE(hfrac_step(witness, 1), 0);
    EXPECT_EQ(hash_of(witness), after);
  }
}

// Calls that read leave the simulation usable, and give the right answer the next time.
TEST(OutOfMemory, ReadingGivesAStatusAndChangesNothing) {
  const Sim sim(small_def());
  ASSERT_GE(hfrac_step(sim, 2), 0);
  const int64_t hash = hash_of(sim);
  int64_t size = 0;
  ASSERT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
  std::vector<char> image(static_cast<std::size_t>(size));
  std::string file = (std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : std::string("/tmp")) +
                     "/hfrac_memory_XXXXXX";
  ASSERT_GE(::mkstemp(file.data()), 0);
  hfrac_balance balance{};
  balance.struct_size = sizeof balance;
  hfrac::Definition def = new_def();
  char text[64];
  int32_t needed = 0;
  const std::function<int32_t()> calls[] = {
      [&] { return hfrac_state_save(sim, image.data(), size, nullptr); },
      [&] { return hfrac_state_save_file(sim, file.c_str()); },
      [&] { return hfrac_get_balance(sim, &balance); },
      [&] { return hfrac_sim_definition(sim, &def); },
      [&] { return hfrac_sim_def_write(&def, text, sizeof text, &needed); },
      [&] { return hfrac_sim_def_check(&def); },
      [&] {
        int64_t value = 0;
        return hfrac_state_hash(sim, &value);
      },
  };
  for (const auto& call : calls) {
    run_out_everywhere(
        true, [] {}, call,
        [&](int32_t status, long place) {
          ASSERT_TRUE(status == HFRAC_OK || status == HFRAC_ERR_MEMORY) << place << " " << status;
          ASSERT_EQ(hash_of(sim), hash) << place;
        });
  }
  EXPECT_EQ(hfrac_state_load_file(sim, file.c_str()), HFRAC_OK) << last_error(sim);
  EXPECT_EQ(hash_of(sim), hash);
  ::unlink(file.c_str());
}

// Restoring: done as a whole, or refused and the simulation says that it is unusable.
TEST(OutOfMemory, RestoreGivesAStatus) {
  const hfrac::Definition def = small_def();
  const Sim saved(def);
  ASSERT_GE(hfrac_step(saved, 2), 0);
  const int64_t hash = hash_of(saved);
  int64_t size = 0;
  ASSERT_EQ(hfrac_state_size(saved, &size), HFRAC_OK);
  std::vector<char> image(static_cast<std::size_t>(size));
  ASSERT_EQ(hfrac_state_save(saved, image.data(), size, &size), HFRAC_OK);
  hfrac_sim* sim = nullptr;
  const int times = run_out_everywhere(
      false, [&] { ASSERT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK); },
      [&] { return hfrac_state_restore(sim, image.data(), size); },
      [&](int32_t status, long place) {
        ASSERT_TRUE(status == HFRAC_OK || status == HFRAC_ERR_MEMORY) << place << " " << last_error(sim);
        if (status == HFRAC_OK) {
          ASSERT_EQ(hash_of(sim), hash) << place;
        }
        ASSERT_EQ(hfrac_sim_destroy(&sim), HFRAC_OK);
      });
  EXPECT_GT(times, 1);
}

// As under `ulimit -v`: a model too large for what the process may have is refused, at whatever size the limit stands.
TEST(OutOfMemory, ALimitOnAddressSpaceIsAStatus) {
  int refused = 0;
  for (const long megabytes : {8, 16, 24, 32, 64, 128}) {
    const ::pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ::alarm(100);
      long pages = 0;
      if (FILE* statm = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(statm, "%ld", &pages) != 1) pages = 0;
        std::fclose(statm);
      }
      const auto bytes = static_cast<rlim_t>(pages * ::sysconf(_SC_PAGESIZE) + (megabytes << 20U));
      const ::rlimit limit{bytes, bytes};
      ::setrlimit(RLIMIT_AS, &limit);
      hfrac::Definition def = cracking_def(8000);
      def.packing_residual = 1e-1;
      def.stepping_force_ratio = 1e-1;
      def.stepping_max_cycles = 20;
      def.run_workers = 4;
      hfrac_sim* sim = nullptr;
      const int32_t status = hfrac_sim_create(&def, &sim);
      const bool good = (status == HFRAC_OK && sim != nullptr) ||
                        (status == HFRAC_ERR_MEMORY && sim == nullptr && !last_error().empty());
      ::_exit(good ? (status == HFRAC_OK ? 0 : 1) : 2);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status)) << megabytes << " MB: signal " << WTERMSIG(status);
    ASSERT_LE(WEXITSTATUS(status), 1) << megabytes << " MB";
    refused += WEXITSTATUS(status);
  }
  EXPECT_GT(refused, 0) << "no limit was low enough to say anything";
}

}  // namespace
