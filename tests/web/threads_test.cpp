// SPDX-License-Identifier: BSD-3-Clause
// Work shared out to threads is done once each, and what one of them throws comes out on the calling one.
#include "run/threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using hfrac::run::share_out;

TEST(ShareOut, DoesEachItemOnce) {
  for (const int workers : {-1, 0, 1, 2, 7}) {
    for (const size_t count : {0, 1, 6, 1000}) {
      std::vector<std::atomic<int>> done(count);
      share_out(workers, count, [&](size_t worker, size_t item) {
        EXPECT_LT(worker, static_cast<size_t>(std::max(workers, 1)));
        ++done[item];
      });
      for (const auto& times : done) EXPECT_EQ(times, 1) << workers << " workers, " << count << " items";
    }
  }
}

TEST(ShareOut, ThrowsWhatATaskThrew) {
  for (const int workers : {1, 2, 4}) {
    const auto one_fails = [](size_t, size_t item) {
      if (item == 20) throw std::runtime_error("item 20");
    };
    try {
      share_out(workers, 1000, one_fails);
      ADD_FAILURE() << "nothing was thrown with " << workers << " workers";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "item 20");
    }
  }
}

// A host's handlers run on the host's own threads.
TEST(ShareOut, HelpersSeeNoSignal) {
  const auto here = std::this_thread::get_id();
  std::atomic<int> at{0};
  share_out(2, 2, [&](size_t, size_t) {
    ++at;
    while (at < 2) std::this_thread::yield();  // so that each of the two has one
    if (std::this_thread::get_id() == here) return;
    sigset_t blocked;
    ::pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGCHLD})
      EXPECT_EQ(::sigismember(&blocked, signal), 1);
  });
  sigset_t blocked;
  ::pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
  EXPECT_EQ(::sigismember(&blocked, SIGINT), 0);
}

}  // namespace
