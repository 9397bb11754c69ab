// SPDX-License-Identifier: BSD-3-Clause
// Random numbers that depend on nothing but the seed: SplitMix64 (Steele, Lea and Flood 2014). The standard
// library's distributions differ between implementations, so the few that are needed stand here.
#pragma once

#include <cstdint>

namespace hfrac {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
  }

  // Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

  // Uniform integer in [0, n). The bias of the plain remainder is below n / 2^64.
  std::uint64_t below(std::uint64_t n) { return next() % n; }

 private:
  std::uint64_t state_;
};

// Fisher-Yates shuffle, the same on every platform.
template <class Container>
void shuffle(Container& items, Random& random) {
  for (std::size_t k = items.size(); k > 1; --k) std::swap(items[k - 1], items[random.below(k)]);
}

}  // namespace hfrac
