// SPDX-License-Identifier: BSD-3-Clause
// Two discs far apart, which hold a model that nothing else holds: the pins of the quasi-static solver (equilibrium/coupled_system.hpp), and
// what takes up the turn of a fracture's facets in motion (solid/facet_motion.hpp). The same two for both.
#pragma once

#include <cmath>
#include <cstdint>

#include "model/assembly.hpp"

namespace hfrac {

struct FarDiscs {
  std::int32_t lowest = 0, far = 0;  // the one at the lower left, and the farthest from it
  double distance = 0.0;             // m
};

inline FarDiscs far_discs(const Assembly& a) {
  FarDiscs found;
  const auto discs = static_cast<std::int32_t>(a.disc_count());
  for (std::int32_t i = 1; i < discs; ++i)
    if (a.x[i] + a.y[i] < a.x[found.lowest] + a.y[found.lowest]) found.lowest = i;
  const auto distance = [&](std::int32_t i) {
    return std::hypot(a.x[i] - a.x[found.lowest], a.y[i] - a.y[found.lowest]);
  };
  for (std::int32_t i = 1; i < discs; ++i)
    if (distance(i) > distance(found.far)) found.far = i;
  found.distance = distance(found.far);
  return found;
}

}  // namespace hfrac
