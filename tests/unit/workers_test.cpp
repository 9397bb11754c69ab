// SPDX-License-Identifier: BSD-3-Clause
// The barrier holds with fewer, as many and far more workers than cores: what was written before it is seen behind it. A team
// that waits for one of its workers becomes smaller, and large again later. Workers leave the host's signals to the host.
#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "core/workers.hpp"

namespace workers_test {

using namespace hfrac;

TEST(Workers, MeetAtTheBarrierWhateverTheirNumber) {
  for (const int count : {1, 2, 3, 8, 33}) {
    Workers workers(count);
    ASSERT_EQ(workers.count(), count);
    constexpr int rounds = 200;
    std::vector<int> written(static_cast<std::size_t>(count),
                             0);  // plain numbers: the barrier alone orders them
    std::atomic<int> wrong{0};
    for (int region = 0; region < 3; ++region) {
      workers.run([&](int worker) {
        if (worker == 0) {
          for (int& other : written) other = 0;
          written.resize(static_cast<std::size_t>(workers.active()));
        }
        workers.barrier();
        for (int round = 1; round <= rounds; ++round) {
          written[static_cast<std::size_t>(worker)] = round;
          workers.barrier();
          for (const int other : written) wrong += other != round ? 1 : 0;
          workers.barrier();
        }
      });
    }
    EXPECT_EQ(wrong, 0) << count << " workers";
  }
}

TEST(Workers, PartsCoverEverythingOnce) {
  for (const int count : {1, 3, 8}) {
    const Workers workers(count);
    for (const std::int64_t n : {0, 1, 7, 64, 1000}) {
      std::int64_t next = 0;
      for (int worker = 0; worker < count; ++worker) {
        const auto [first, last] = workers.part(worker, n, 8);
        EXPECT_EQ(first, next);
        EXPECT_LE(first, last);
        next = last;
      }
      EXPECT_EQ(next, n);
    }
  }
}

// Runs tasks of two barriers until the team has that size; false after some seconds.
bool becomes(Workers& workers, int active, bool held_up) {
  using namespace std::chrono_literals;
  const auto end = std::chrono::steady_clock::now() + 30s;
  while (workers.active() != active) {
    if (std::chrono::steady_clock::now() > end) return false;
    workers.run([&](int worker) {
      if (held_up && worker == workers.active() - 1) std::this_thread::sleep_for(2ms);
      workers.barrier();
      workers.barrier();
    });
    std::this_thread::sleep_for(100us);
  }
  return true;
}

TEST(Workers, BecomeFewerWhereOneIsWaitedForAndMoreAgain) {
  Workers workers(2);
  ASSERT_EQ(workers.active(), 2);
  EXPECT_TRUE(becomes(workers, 1, true));
  EXPECT_TRUE(becomes(workers, 2, false));
}

TEST(Workers, CutATaskShortInWhichTheyWait) {
  using namespace std::chrono_literals;
  Workers workers(2);
  int rounds = 0;
  workers.run([&](int worker) {
    for (int round = 0; round < 500; ++round) {
      if (worker == 1) std::this_thread::sleep_for(2ms);
      workers.barrier();
      if (worker == 0) ++rounds;
      if (workers.cut_short()) return;
    }
  });
  EXPECT_LT(rounds, 50);
}

TEST(Workers, TakeEveryItemOfAPassOnce) {
  for (const int count : {1, 2, 5}) {
    Workers workers(count);
    Workers::Pass pass(count);
    std::vector<std::atomic<int>> taken(101);
    for (int turn = 1; turn <= 20; ++turn) {
      pass.refill(workers, static_cast<std::int64_t>(taken.size()));
      workers.run([&](int worker) {
        pass.take(worker, [&](std::int64_t item) { ++taken[static_cast<std::size_t>(item)]; });
      });
      for (const auto& times : taken) ASSERT_EQ(times, turn) << count << " workers";
    }
  }
}

TEST(Workers, BlockSignalsAndLeaveTheCallersMask) {
  Workers workers(3);
  std::atomic<int> open{0};
  workers.run([&](int worker) {
    sigset_t blocked;
    pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
    for (const int number : {SIGINT, SIGALRM, SIGTERM, SIGUSR1})
      open += worker != 0 && sigismember(&blocked, number) == 0 ? 1 : 0;
  });
  EXPECT_EQ(open, 0);
  sigset_t mine;
  pthread_sigmask(SIG_BLOCK, nullptr, &mine);
  EXPECT_EQ(sigismember(&mine, SIGINT), 0);
}

}  // namespace workers_test
