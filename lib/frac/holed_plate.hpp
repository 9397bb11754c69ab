// SPDX-License-Identifier: BSD-3-Clause
// Stress in an elastic plate under its far field with round holes that a fluid fills (Kirsch 1898), compression positive.
//
// Each hole adds what it would alone, which is right if holes lie several radii apart.
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

struct HoledPlate {
  struct Hole {
    Vec2 centre;               // m
    double radius;             // m
    double pressure;           // Pa
    std::int32_t domain = -1;  // of the network, that is the hole
  };
  struct Stress {
    double xx, yy, xy;  // Pa
  };
  double far_xx = 0.0, far_yy = 0.0;  // Pa
  std::vector<Hole> holes;

  [[nodiscard]] Stress at(Vec2 place) const;
};

}  // namespace hfrac
