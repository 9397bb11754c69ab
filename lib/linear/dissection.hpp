// SPDX-License-Identifier: BSD-3-Clause
// An order of elimination for sparse factors of planar models: nested dissection by position (George 1973).
//
// The model is cut in two where it is longest, the fewest unknowns that part the halves (separator.hpp) go last, and each half
// is treated alike. In two
// dimensions this keeps the factor of N unknowns at O(N log N) entries and O(N^1.5) operations. Where nodes lie is known here,
// so no graph partitioner is needed, and the order depends on nothing but the model.
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

// Neighbours of every node, without itself: neighbour[start[k] .. start[k + 1]), ascending.
struct Adjacency {
  std::vector<std::int32_t> start, neighbour;
};

// The tree of cuts, children before parents. A part's own nodes, order[first .. last), are those along its cut, or all of an
// uncut one; they touch only nodes of its children, of its ancestors and each other.
struct Dissection {
  struct Part {
    std::int32_t first, last;
    std::int32_t parent;  // -1: the last one
  };
  std::vector<std::int32_t> order;
  std::vector<Part> parts;
};

// weight: unknowns of each node. Nodes with `late` set touch too many others to be cut around: they form the last part.
Dissection dissect(const std::vector<Vec2>& position, const Adjacency& graph,
                   const std::vector<std::int32_t>& weight, const std::vector<char>& late);

}  // namespace hfrac
