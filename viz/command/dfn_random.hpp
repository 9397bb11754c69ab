// SPDX-License-Identifier: BSD-3-Clause
// Random numbers by a seed, the same on every platform: the Mersenne twister of 32 bits seeded by an array of words and drawn from with 53
// bits a number (Matsumoto and Nishimura 1998, and their mt19937ar of 2002), as Python's `random` does. The distributions of the standard
// library differ from one to the next, so those needed stand here.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace hfrac::command {

/** The state that a seed of 64 bits begins with, in the form that the standard's engines take. */
class SeedWords {
 public:
  using result_type = uint32_t;
  explicit SeedWords(uint64_t seed)
      : words_{static_cast<uint32_t>(seed), static_cast<uint32_t>(seed >> 32U)},
        count_(words_[1] != 0 ? 2U : 1U) {}

  template <class Iterator>
  void generate(Iterator first, Iterator last) const {
    const auto count = static_cast<uint32_t>(last - first);
    const auto before = [&](uint32_t i) {
      const uint32_t word = static_cast<uint32_t>(first[i == 0 ? count - 1 : i - 1]);
      return word ^ (word >> 30U);
    };
    first[0] = 19650218U;
    for (uint32_t i = 1; i < count; ++i) first[i] = 1812433253U * before(i) + i;
    uint32_t i = 1, word = 0;
    const auto advance = [&] {
      if (++i < count) return;
      first[0] = first[count - 1];
      i = 1;
    };
    for (uint32_t k = std::max(count, count_); k > 0; --k) {
      first[i] = (first[i] ^ (before(i) * 1664525U)) + words_[word] + word;
      word = (word + 1) % count_;
      advance();
    }
    for (uint32_t k = count - 1; k > 0; --k) {
      first[i] = (first[i] ^ (before(i) * 1566083941U)) - i;
      advance();
    }
    first[0] = 0x80000000U;
  }

 private:
  std::array<uint32_t, 2> words_;
  uint32_t count_;
};

class Dice {
 public:
  explicit Dice(uint64_t seed) : engine_(words_of(seed)) {}

  /** Uniform in [0, 1). */
  double uniform() {
    const double high = static_cast<double>(engine_() >> 5U), low = static_cast<double>(engine_() >> 6U);
    return (high * 0x1p26 + low) * 0x1p-53;
  }

  /** An angle in [0, 2 pi) around 0 by von Mises's distribution (Best and Fisher 1979). */
  double von_mises(double concentration) {
    constexpr double pi = std::numbers::pi, least = 1e-6;
    if (concentration <= least) return 2.0 * pi * uniform();
    const double s = 0.5 / concentration, r = s + std::sqrt(1.0 + s * s);
    double z = 0.0, c = 0.0, chance = 0.0;
    do {
      z = std::cos(pi * uniform());
      c = r / (r + z);
      chance = uniform();
    } while (chance >= c * (2.0 - c) && chance > c * std::exp(1.0 - c));
    const double angle = std::acos(std::clamp((1.0 + r * z) / (r + z), -1.0, 1.0));
    return uniform() > 0.5 ? angle : 2.0 * pi - angle;
  }

  /** A standard normal number (Box and Muller 1958). */
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  static std::mt19937 words_of(uint64_t seed) {
    SeedWords words(seed);
    return std::mt19937(words);
  }
  std::mt19937 engine_;
};

}  // namespace hfrac::command
