// SPDX-License-Identifier: BSD-3-Clause
#include "model/smooth_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {

bool crosses(Vec2 from, Vec2 to, Vec2 p, Vec2 q) {
  const Vec2 along = to - from, bond = q - p;
  const auto apart = [](double a, double b) { return (a > 0.0) != (b > 0.0); };
  return apart(cross(along, p - from), cross(along, q - from)) &&
         apart(cross(bond, from - p), cross(bond, to - p));
}

std::vector<Vec2> places_along(Vec2 from, Vec2 to, double pace) {
  const Vec2 along = to - from;
  const auto paces = static_cast<std::int64_t>(std::ceil(norm(along) / pace));
  std::vector<Vec2> places;
  for (std::int64_t k = 0; k <= paces; ++k)
    places.push_back(from + (static_cast<double>(k) / static_cast<double>(std::max<std::int64_t>(1, paces))) *
                                along);
  return places;
}

void SmoothJoints::sort_lines(double cell) {
  std::vector<double> x, y;
  line_at_.clear();
  pace_ = cell;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    for (const Vec2 at : places_along(lines[k].from, lines[k].to, pace_)) {
      x.push_back(at.x);
      y.push_back(at.y);
      line_at_.push_back(static_cast<std::int32_t>(k));
    }
  }
  places_.emplace(x, y, cell);
}

bool SmoothJoints::separate(Vec2 p, Vec2 q) const {
  if (lines.empty()) return false;
  const Vec2 middle = 0.5 * (p + q);
  bool found = false;
  const double reach = 0.5 * norm(q - p) + pace_;
  places_->near(middle.x, middle.y, reach, [&](std::int32_t at) {
    const Line& line = lines[static_cast<std::size_t>(line_at_[static_cast<std::size_t>(at)])];
    found = found || crosses(line.from, line.to, p, q);
  });
  return found;
}

std::int32_t SmoothJoints::opening_at(std::int64_t bond) const {
  if (empty()) return -1;
  if (const auto own = index.place_of(bond); own >= 0) return own;
  const auto found = std::lower_bound(bridges.begin(), bridges.end(), bond,
                                      [](const Bridge& bridge, std::int64_t b) { return bridge.bond < b; });
  return found != bridges.end() && found->bond == bond ? found->contact : -1;
}

}  // namespace hfrac
