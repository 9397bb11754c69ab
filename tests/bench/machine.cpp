// SPDX-License-Identifier: BSD-3-Clause
#include "machine.hpp"

#include <algorithm>
#include <ctime>
#include <thread>
#include <vector>

#include "core/array.hpp"

namespace hfrac::bench {
namespace {

// Seconds: of processor time for one thread, by the clock for more.
double now(int threads) {
  timespec t{};
  clock_gettime(threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// Seconds from the first thread's start to the last one's end, the best of some rounds.
template <class Work>
double best_of(int rounds, int threads, Work&& work) {
  double best = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const double start = now(threads);
    std::vector<std::thread> others;
    others.reserve(static_cast<std::size_t>(threads - 1));
    for (int t = 1; t < threads; ++t) others.emplace_back([&work, t] { work(t); });
    work(0);
    for (auto& other : others) other.join();
    best = std::min(best, now(threads) - start);
  }
  return best;
}

#if defined(__x86_64__)
__attribute__((target_clones("avx512f", "avx2", "default")))
#endif
void
multiply_and_add(double* x, std::size_t count, std::size_t repeats) {
  for (std::size_t k = 0; k < repeats; ++k) {
    for (std::size_t i = 0; i < count; ++i) x[i] = x[i] * 0.999999 + 1e-7;
    asm volatile("" : : "r"(x) : "memory");
  }
}

}  // namespace

double triad(std::size_t count, int rounds, int threads) {
  // Starts staggered: arrays that all begin at the same offset of a page alias in the cache.
  struct Arrays {
    Array<double> a, b, c;
  };
  std::vector<Arrays> all;
  for (int t = 0; t < threads; ++t)
    all.push_back(
        {Array<double>(count + 200, 0.0), Array<double>(count + 400, 1.0), Array<double>(count + 600, 2.0)});
  const std::size_t repeats = std::max<std::size_t>(1, (std::size_t{1} << 25U) / count);
  const double seconds = best_of(rounds, threads, [&](int t) {
    Arrays& mine = all[static_cast<std::size_t>(t)];
    double* to = mine.a.data() + 104;
    const double *from = mine.b.data() + 248, *also = mine.c.data() + 392;
    for (std::size_t k = 0; k < repeats; ++k) {
      const double s = 3.0 + static_cast<double>(k);
#pragma GCC ivdep
      for (std::size_t i = 0; i < count; ++i) to[i] = from[i] + s * also[i];
      asm volatile("" : : "r"(to) : "memory");
    }
  });
  return 24.0 * static_cast<double>(count * repeats) * threads / seconds;
}

double multiply_add(int rounds, int threads) {
  // Enough independent values to hide latency, few enough to stay in the first-level cache.
  constexpr std::size_t count = 512, repeats = 1U << 18U;
  std::vector<Array<double>> all(static_cast<std::size_t>(threads), Array<double>(count, 1.0));
  const double seconds = best_of(rounds, threads, [&](int t) {
    multiply_and_add(all[static_cast<std::size_t>(t)].data(), count, repeats);
  });
  return 2.0 * static_cast<double>(count) * static_cast<double>(repeats) * threads / seconds;
}

}  // namespace hfrac::bench
