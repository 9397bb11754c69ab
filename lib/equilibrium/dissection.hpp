// SPDX-License-Identifier: BSD-3-Clause
// An order of elimination for sparse factors of planar models: nested dissection by position (George 1973).
//
// The model is cut in two where it is longest, the nodes along the cut go last, and each half is treated alike. In two
// dimensions this keeps the factor of N unknowns at O(N log N) entries and O(N^1.5) operations. Where nodes lie is known here,
// so no graph partitioner is needed, and the order depends on nothing but the model.
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

// Neighbours of every node, without itself: neighbour[start[k] .. start[k + 1]).
struct Adjacency {
  std::vector<std::int32_t> start, neighbour;
};

// Nodes in order of elimination. `last` nodes, at the end of `position`, touch any others and are eliminated after all the rest.
std::vector<std::int32_t> dissect(const std::vector<Vec2>& position, const Adjacency& graph,
                                  std::int32_t last);

}  // namespace hfrac
