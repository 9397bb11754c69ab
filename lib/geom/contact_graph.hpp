// SPDX-License-Identifier: BSD-3-Clause
// Which discs are bonded: a planar graph of near contacts without loose ends.
//
// Steps: cut the wells (discs whose centre lies inside a hole go), join all pairs closer than the gap tolerance, drop
// the longer of two joins that cross, drop discs with fewer than two joins until none is left, keep the largest
// connected piece. What remains has planar faces, every disc is held, and Euler's N - E + F = 2 holds (faces.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

struct Hole {
  Vec2 centre;    // m
  double radius;  // m
};

struct ContactGraph {
  Array<double> x, y, radius;        // m; discs kept, order of the packing
  std::vector<std::int32_t> first;   // disc i of each edge, first < second
  std::vector<std::int32_t> second;  // sorted by (first, second)
  double mean_radius = 0.0;          // m, of all discs given
  std::int64_t removed_in_wells = 0, removed_floaters = 0, removed_crossings = 0;
};

// Throws Error(model) if nothing coherent is left.
ContactGraph build_contact_graph(const Array<double>& x, const Array<double>& y, const Array<double>& radius,
                                 const std::vector<Hole>& holes, double gap_tolerance);

}  // namespace hfrac
