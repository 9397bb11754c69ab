// SPDX-License-Identifier: BSD-3-Clause
// Random numbers by a seed, the same on every platform: the Mersenne twister of 64 bits (Matsumoto and Nishimura 1998). The standard says
// what its engines give, and leaves its distributions to each library, so those needed stand here.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace hfrac::command {

class Dice {
 public:
  explicit Dice(uint64_t seed) : engine_(seed) {}

  /** Uniform in [0, 1). */
  double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

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
  std::mt19937_64 engine_;
};

}  // namespace hfrac::command
