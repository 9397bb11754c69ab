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
  constexpr double paces = 4.0;  // few places, and few lines near each
  pace_ = paces * cell;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    for (const Vec2 at : places_along(lines[k].from, lines[k].to, pace_)) {
      x.push_back(at.x);
      y.push_back(at.y);
      line_at_.push_back(static_cast<std::int32_t>(k));
    }
  }
  places_.emplace(x, y, pace_);
}

bool SmoothJoints::any_between(Vec2 p, Vec2 q, std::int32_t but) const {
  if (lines.empty()) return false;
  const Vec2 middle = 0.5 * (p + q);
  bool found = false;
  const double reach = 0.5 * norm(q - p) + pace_;
  places_->near(middle.x, middle.y, reach, [&](std::int32_t at) {
    const std::int32_t k = line_at_[static_cast<std::size_t>(at)];
    const Line& line = lines[static_cast<std::size_t>(k)];
    found = found || (k != but && crosses(line.from, line.to, p, q));
  });
  return found;
}

std::int32_t SmoothJoints::moved_over(std::int32_t disc) const {
  const auto found = std::lower_bound(moved.begin(), moved.end(), disc,
                                      [](const Moved& m, std::int32_t d) { return m.disc < d; });
  return found != moved.end() && found->disc == disc ? found->line : -1;
}

bool SmoothJoints::separate(Vec2 p, Vec2 q) const {
  return any_between(p, q, -1);
}

bool SmoothJoints::separate(std::int32_t i, Vec2 p, std::int32_t j, Vec2 q) const {
  const auto over = moved_over(i), other = moved_over(j);
  if (over == other) return separate(p, q);
  const auto k = over >= 0 ? over : other;
  const Line& line = lines[static_cast<std::size_t>(k)];
  return !crosses(line.from, line.to, p, q) || any_between(p, q, k);
}

std::int32_t SmoothJoints::opening_at(std::int64_t bond) const {
  if (empty()) return -1;
  if (const auto own = index.place_of(bond); own >= 0) return own;
  const auto found = std::lower_bound(bridges.begin(), bridges.end(), bond,
                                      [](const Bridge& bridge, std::int64_t b) { return bridge.bond < b; });
  return found != bridges.end() && found->bond == bond ? found->contact : -1;
}

}  // namespace hfrac
