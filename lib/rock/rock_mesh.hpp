// SPDX-License-Identifier: BSD-3-Clause
// Meshes of nine-node quadrilaterals for the continuum: a rectangle, and a rectangle with a round well in it.
//
// Both are one block of elements, na by nb, bent into shape: for the rectangle a runs along x and b along y; round the
// well a runs outward and b anticlockwise, and the block closes upon itself. Sides of an element are parabolas through
// its mid-side nodes, so a well is round to the fourth order of the element's angle.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

enum class RockSide { left, right, bottom, top, well };

struct RockMesh {
  // Nodes 0-3 are corners, anticlockwise; 4-7 the middles of the sides 01, 12, 23, 30; 8 the centre.
  using Element = std::array<std::int32_t, 9>;
  // One element's side on the border, the body to its left from `from` to `to`.
  struct Edge {
    RockSide side;
    std::int32_t from, middle, to;
  };
  std::vector<Vec2> node;  // [m]
  std::vector<Element> element;
  std::vector<Edge> edge;
};

// 0 to width by 0 to height with a circular hole that lies inside [m]. `around`: elements round the hole, raised to a
// multiple of 4; `outward`: elements from the hole to the outer boundary, growing in proportion to their distance.
RockMesh plate_mesh(double width, double height, Vec2 centre, double radius, int around, int outward);

}  // namespace hfrac
