// SPDX-License-Identifier: BSD-3-Clause
// The barrier holds with fewer, as many and far more workers than cores: what was written before it is seen behind it.
#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "core/workers.hpp"

namespace {

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

}  // namespace
