// SPDX-License-Identifier: BSD-3-Clause
// Which sources of shaking are one event: those near each other in place and time, over any number of links.
//
// After Hazzard and Young (2000, Int. J. Rock Mech. Min. Sci. 37, 867-872; 2004, ibid. 41, 1365-1376): a crack's source region
// reaches one disc diameter around it, and cracks whose regions overlap while they are active are one event. Here: two
// sources are linked if they are at most `distance` apart and began at most `time_window` and `cycle_window` apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

struct Source {
  Vec2 position{};             // m
  double disc_distance = 0.0;  // m, between the centres of its discs
  double time = 0.0;           // s
  std::int64_t cycle = 0;
};

struct LinkRule {
  double distance = 0.0;          // m; 0: twice the mean distance between the discs of the sources
  double time_window = 0.0;       // s; 0: the same time
  std::int64_t cycle_window = 0;  // mechanical cycles; 0: no limit
};

// Places in `sources`, ascending, of each event's members; events in order of their first.
std::vector<std::vector<std::size_t>> linked_sources(std::span<const Source> sources, const LinkRule& rule);

}  // namespace hfrac
