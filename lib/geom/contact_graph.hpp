// SPDX-License-Identifier: BSD-3-Clause
// Which discs are bonded: a planar graph of near contacts without loose ends.
//
// Steps: cut the wells (discs whose centre lies inside a hole go), join all pairs closer than the gap tolerance, drop
// the longer of two joins that cross, drop discs with fewer than two joins until none is left, keep the largest
// connected piece. What remains has planar faces, every disc is held, and Euler's N - E + F = 2 holds (faces.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/array.hpp"
#include "core/layout.hpp"
#include "options/grading.hpp"

namespace hfrac {

struct Hole {
  Vec2 centre;    // m
  double radius;  // m
};

// Where the edge of some rank (by first and second disc) among the `count` edges of a tile stands. Edges in a row that share
// discs would make each addition to a disc's force wait for the one before; so eight stretches of the sorted list take turns.
inline std::int64_t edge_at(std::int64_t rank, std::int64_t count) {
  constexpr std::int64_t stretches = 8;
  const std::int64_t length = count / stretches, longer = count % stretches;
  const std::int64_t in_longer = longer * (length + 1);
  return rank < in_longer ? (rank % (length + 1)) * stretches + rank / (length + 1)
                          : ((rank - in_longer) % length) * stretches + longer + (rank - in_longer) / length;
}

struct ContactGraph {
  Array<double> x, y, radius;       // m; discs kept, order of the packing
  std::vector<std::int32_t> first;  // disc i of each edge, first < second
  std::vector<std::int32_t> second;
  std::vector<std::uint8_t> bonded;  // 1, or 0 where a host's list of bonds left a near pair out
  // Where each part of the edges begins, and last their number. With T tiles of discs, part t < T are those inside tile t,
  // interleaved (edge_at). Then a part for each pair of tiles, by the first, then by the second; in it edges go by (first, second).
  std::vector<std::int64_t> part_first_edge;
  std::vector<std::int32_t> tile_first_pair;  // by tile: its first pair's part, and last the number of parts
  [[nodiscard]] std::int64_t first_cross_edge() const { return part_first_edge[tile_first_pair.size() - 1]; }
  double mean_radius = 0.0;  // m, of all discs given; graded: of the fine ones
  Grading sizes;             // of a graded packing
  std::int64_t removed_in_wells = 0, removed_floaters = 0, removed_crossings = 0;
};

// `bonds`: pairs of indices of discs that are bonded, near or not; none: all that are near. Near discs that a list leaves out
// are edges without a bond. `sizes`: of a graded packing, whose tolerance goes with the mean radius around each disc. Throws Error(model) if nothing coherent is left.
ContactGraph build_contact_graph(const Array<double>& x, const Array<double>& y, const Array<double>& radius,
                                 const std::vector<Hole>& holes, double gap_tolerance,
                                 std::span<const std::int64_t> bonds = {}, const Grading& sizes = {});

}  // namespace hfrac
