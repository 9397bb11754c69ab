// SPDX-License-Identifier: BSD-3-Clause
// Simulations know nothing of each other, nor do results of the number of workers.
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <thread>

#include "../thread_sanitizer.hpp"
#include "sim_support.hpp"

namespace isolation_test {

using namespace testing_capi;

// Different ones, of either solver; each must give what it gives alone.
hfrac::Definition definition(int number) {
  hfrac::Definition def = number % 2 == 0 ? cracking_def() : quiet_def(600);
  def.model_seed = number + 1;
  if (number % 4 == 1) def.solver_kind = 1;  // quasi-static
  def.run_workers = number == 2 ? 2 : 1;
  return def;
}

std::vector<int64_t> hashes_alone(int number, int steps) {
  const Sim sim(definition(number));
  std::vector<int64_t> hashes;
  for (int k = 0; k < steps; ++k) {
    EXPECT_EQ(hfrac_step(sim, 1), HFRAC_OK);
    hashes.push_back(hash_of(sim));
  }
  return hashes;
}

TEST(Isolation, InterleavedSimulationsGiveWhatEachGivesAlone) {
  const auto first = hashes_alone(0, 3), second = hashes_alone(1, 3);
  const Sim one(definition(0));
  ASSERT_EQ(hfrac_step(one, 1), HFRAC_OK);
  const Sim other(definition(1));  // built while the other one is under way
  EXPECT_EQ(hash_of(one), first[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(hfrac_step(other, 1), HFRAC_OK);
    EXPECT_EQ(hash_of(other), second[k]);
    if (k == 2) break;
    ASSERT_EQ(hfrac_step(one, 1), HFRAC_OK);
    EXPECT_EQ(hash_of(one), first[k + 1]);
  }
}

TEST(Isolation, OneDestroyedLeavesTheOtherAlone) {
  const auto alone = hashes_alone(0, 2);
  const Sim kept(definition(0));
  {
    const Sim passing(definition(1));
    ASSERT_EQ(hfrac_step(passing, 1), HFRAC_OK);
    ASSERT_EQ(hfrac_step(kept, 1), HFRAC_OK);
  }
  ASSERT_EQ(hfrac_step(kept, 1), HFRAC_OK);
  EXPECT_EQ(hash_of(kept), alone[1]);
}

TEST(Isolation, FourThreadsGiveWhatOneGives) {
  constexpr int steps = 3;
  std::vector<std::vector<int64_t>> alone, together(4);
  for (int number = 0; number < 4; ++number) alone.push_back(hashes_alone(number, steps));
  std::vector<std::thread> threads;
  for (int number = 0; number < 4; ++number) {
    threads.emplace_back(
        [&, number] { together[static_cast<std::size_t>(number)] = hashes_alone(number, steps); });
  }
  for (auto& thread : threads) thread.join();
  for (std::size_t number = 0; number < 4; ++number) EXPECT_EQ(together[number], alone[number]) << number;
}

// Eight at once, of different rock, some with workers of their own.
TEST(Isolation, EightThreadsGiveWhatOneGives) {
  constexpr int steps = 2, threads_at_once = 8;
  std::vector<std::vector<int64_t>> alone, together(threads_at_once);
  for (int number = 0; number < threads_at_once; ++number) alone.push_back(hashes_alone(number, steps));
  std::vector<std::thread> threads;
  for (int number = 0; number < threads_at_once; ++number) {
    threads.emplace_back(
        [&, number] { together[static_cast<std::size_t>(number)] = hashes_alone(number, steps); });
  }
  for (auto& thread : threads) thread.join();
  for (std::size_t number = 0; number < together.size(); ++number)
    EXPECT_EQ(together[number], alone[number]) << number;
}

// A child of fork has the memory but not the threads: one worker goes on as in the parent, several are refused with a text,
// never a wait without end, and new simulations are as good as anywhere.
TEST(Isolation, AForkedChildIsToldWhatItCanDo) {
  hfrac::Definition several = quiet_def();
  several.run_workers = 2;
  const Sim one(quiet_def()), two(several);
  const ::pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::alarm(60);
    bool good = hfrac_step(one, 1) == HFRAC_OK && hfrac_step(two, 1) == HFRAC_ERR_ARGUMENT &&
                last_error(two).find("forked") != std::string::npos;
    hfrac_sim* gone = two;
    good = good && hfrac_sim_destroy(&gone) == HFRAC_OK;
    hfrac_sim* own = nullptr;
    good = good && hfrac_sim_create(&several, &own) == HFRAC_OK && hfrac_step(own, 1) == HFRAC_OK &&
           hash_of(own) == hash_of(one) && hfrac_sim_destroy(&own) == HFRAC_OK;
    ::_exit(good ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(hfrac_step(two, 1), HFRAC_OK) << "the parent goes on";
}

TEST(Isolation, ASimulationMayMoveFromThreadToThread) {
  const auto alone = hashes_alone(2, 3);
  const Sim sim(definition(2));
  for (std::size_t k = 0; k < 3; ++k) {
    std::thread([&] { EXPECT_EQ(hfrac_step(sim, 1), HFRAC_OK); }).join();
    EXPECT_EQ(hash_of(sim), alone[k]);
  }
}

// Several blocks of discs and bonds, so that every worker has some. Short: on a busy machine workers wait for
// each other.
TEST(Isolation, WorkersDoNotChangeResults) {
  const std::vector<std::function<void(hfrac_sim_def&)>> variants = {
      [](hfrac_sim_def&) {},
      [](hfrac_sim_def& def) {
        def.boundary_kind = 0;
        def.contact_mode = 1;
        def.wells[0].pressure = 50e6;  // without walls 70e6 tears it apart
      },
      [](hfrac_sim_def& def) {
        def.stepping_mode = 1;
        def.stepping_flow_step = 2e-3;
      },
  };
  for (std::size_t v = 0; v < variants.size(); ++v) {
    std::vector<Sight> sights;
    for (const int workers : thread_sanitizer::numbers({1, 2, 3}, {3})) {
      hfrac::Definition def = cracking_def(600);
      def.run_workers = workers;
      def.wells[0].pressure = 80e6;
      def.stepping_force_ratio = 1e-2;
      variants[v](def);
      const Sim sim(def);
      ASSERT_GE(hfrac_step(sim, 1), HFRAC_OK) << last_error(sim);
      sights.push_back(sight_of(sim));
      SCOPED_TRACE("variant " + std::to_string(v) + ", workers " + std::to_string(workers));
      expect_same(sights.back(), sights.front());
    }
    EXPECT_EQ(sights[0]["cracks"].empty(), v == 2) << "variant " << v;
  }
}

}  // namespace isolation_test
