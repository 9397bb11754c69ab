// SPDX-License-Identifier: BSD-3-Clause
// The faces of the contact graph: polygons of disc centres that enclose the pores.
//
// Each edge is walked once in either direction, always turning to the next edge clockwise at a disc, so that the face
// lies to the left. Face 0 is the one outside; then come those inside a tile of discs, tile by tile, then the others. The graph is connected, so N - E + F = 2 (Euler), which is checked.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/contact_graph.hpp"

namespace hfrac {

struct Faces {
  std::vector<std::int32_t> left, right;  // face on either side of each edge, seen from first to second disc
  std::vector<std::int32_t>
      corner_start;                  // corners of face f: corner[corner_start[f] .. corner_start[f + 1])
  std::vector<std::int32_t> corner;  // discs, anticlockwise (clockwise around the outside face)
  std::vector<double> polygon_area;  // m2; of the polygon of disc centres, 0 for the outside
  std::vector<Vec2> centroid;        // m
  [[nodiscard]] std::int32_t count() const { return static_cast<std::int32_t>(corner_start.size()) - 1; }
};

Faces build_faces(const ContactGraph& graph);

// The face whose polygon holds a point, the smallest if several do; -1 if none.
std::int32_t face_around(const ContactGraph& graph, const Faces& faces, Vec2 point);

}  // namespace hfrac
