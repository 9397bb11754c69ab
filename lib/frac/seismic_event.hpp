// SPDX-License-Identifier: BSD-3-Clause
// One seismic event, whatever made it, and how strong it was by its moment tensor and energy.
#pragma once

#include <cstdint>

#include "core/array.hpp"

namespace hfrac {

enum class EventKind : std::int32_t { cracks = 0, slip = 1 };

struct SeismicEvent {
  EventKind kind = EventKind::cracks;
  std::int64_t first_crack = -1, crack_count = 0, tensile_cracks = 0;
  std::int64_t first_slip = -1, slip_count = 0;
  std::int64_t first_cycle = 0, last_cycle = 0;
  double time = 0.0;                    // s, of its first source
  double duration = 0.0;                // s, from there to the last
  Vec2 position{};                      // m, middle of its sources
  double xx = 0.0, yy = 0.0, xy = 0.0;  // N m, moment tensor, outward positive
  double moment = 0.0;                  // N m, scalar
  double magnitude = 0.0;               // of the moment
  double energy = 0.0;                  // J, elastic, of the bonds that broke
  double energy_magnitude = 0.0;
  double isotropic_fraction = 0.0;  // -1 to 1
  double length = 0.0;              // m, of what broke or slipped, summed
  double radius = 0.0;              // m, from its position to the farthest source
  double slip = 0.0;                // m, mean over its length
};

// Fills moment, magnitudes and isotropic share from tensor and energy.
void rate_strength(SeismicEvent& event);

}  // namespace hfrac
