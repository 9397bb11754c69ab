// SPDX-License-Identifier: BSD-3-Clause
#include "machine.hpp"

#include <algorithm>
#include <chrono>

#include "core/array.hpp"

namespace hfrac::bench {

double triad(std::size_t count, int rounds) {
  // Starts staggered: arrays that all begin at the same offset of a page alias in the cache.
  Array<double> a(count + 200, 0.0), b(count + 400, 1.0), c(count + 600, 2.0);
  double* to = a.data() + 104;
  const double *from = b.data() + 248, *also = c.data() + 392;
  const std::size_t repeats = std::max<std::size_t>(1, (std::size_t{1} << 25U) / count);
  double best = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t k = 0; k < repeats; ++k) {
      const double s = 3.0 + static_cast<double>(k);
#pragma GCC ivdep
      for (std::size_t i = 0; i < count; ++i) to[i] = from[i] + s * also[i];
      asm volatile("" : : "r"(to) : "memory");
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    best = std::max(best, 24.0 * static_cast<double>(count * repeats) / seconds);
  }
  return best;
}

}  // namespace hfrac::bench
