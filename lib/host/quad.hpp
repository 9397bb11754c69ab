// SPDX-License-Identifier: BSD-3-Clause
// Plane geometry of a host's cells: convex quadrilaterals, what part of a polygon or of a line lies in one.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

using Quad = std::array<Vec2, 4>;  // corners in order, anticlockwise; every inner angle below 180 degrees

// Twice the signed area of the triangle a, b, c: positive if c lies left of a -> b.
inline double turn(Vec2 a, Vec2 b, Vec2 c) {
  return cross(b - a, c - a);
}

inline double area_of(std::span<const Vec2> polygon) {
  double twice = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    twice += cross(polygon[k] - polygon[0], polygon[(k + 1) % polygon.size()] - polygon[0]);
  return 0.5 * twice;
}

inline Vec2 middle_of(const Quad& q) {
  return 0.25 * ((q[0] + q[1]) + (q[2] + q[3]));
}

inline bool holds(const Quad& q, Vec2 p) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (turn(q[k], q[(k + 1) % 4], p) < 0.0) return false;
  }
  return true;
}

// Area of what `polygon` (any shape, anticlockwise) and `q` have in common: Sutherland and Hodgman's clipping (1974).
// A polygon that is not convex may leave edges that run to and fro; they add nothing to the area.
double common_area(std::span<const Vec2> polygon, const Quad& q);

// The share of the line from `a` to `b` that lies in `q`, 0 to 1 (Cyrus and Beck, 1978).
double share_inside(Vec2 a, Vec2 b, const Quad& q);

// Distance from a point to a quadrilateral, 0 inside [m].
double distance_to(const Quad& q, Vec2 p);

}  // namespace hfrac
