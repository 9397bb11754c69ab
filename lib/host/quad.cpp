// SPDX-License-Identifier: BSD-3-Clause
#include "host/quad.hpp"

#include <cmath>

namespace hfrac {

double common_area(std::span<const Vec2> polygon, const Quad& q) {
  std::vector<Vec2> inside(polygon.begin(), polygon.end()), next;
  for (std::size_t side = 0; side < 4 && !inside.empty(); ++side) {
    const Vec2 from = q[side], to = q[(side + 1) % 4];
    next.clear();
    for (std::size_t k = 0; k < inside.size(); ++k) {
      const Vec2 a = inside[k], b = inside[(k + 1) % inside.size()];
      const double at_a = turn(from, to, a), at_b = turn(from, to, b);
      if (at_a >= 0.0) next.push_back(a);
      if ((at_a >= 0.0) != (at_b >= 0.0)) next.push_back(a + (at_a / (at_a - at_b)) * (b - a));
    }
    inside.swap(next);
  }
  return inside.empty() ? 0.0 : area_of(inside);
}

double share_inside(Vec2 a, Vec2 b, const Quad& q) {
  double first = 0.0, last = 1.0;
  for (std::size_t side = 0; side < 4; ++side) {
    const double at_a = turn(q[side], q[(side + 1) % 4], a), at_b = turn(q[side], q[(side + 1) % 4], b);
    if (at_a < 0.0 && at_b < 0.0) return 0.0;
    if (at_a < 0.0) first = std::max(first, at_a / (at_a - at_b));
    if (at_b < 0.0) last = std::min(last, at_a / (at_a - at_b));
  }
  return std::max(0.0, last - first);
}

double distance_to(const Quad& q, Vec2 p) {
  if (holds(q, p)) return 0.0;
  double nearest = -1.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 along = q[(k + 1) % 4] - q[k];
    const double at = std::clamp(dot(p - q[k], along) / dot(along, along), 0.0, 1.0);
    const Vec2 from = p - (q[k] + at * along);
    const double distance = norm(from);
    if (nearest < 0.0 || distance < nearest) nearest = distance;
  }
  return nearest;
}

}  // namespace hfrac
