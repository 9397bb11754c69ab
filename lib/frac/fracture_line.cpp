// SPDX-License-Identifier: BSD-3-Clause
#include "frac/fracture_line.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "frac/fracture_graph.hpp"
#include "frac/fractures.hpp"

namespace hfrac {
namespace {

using Lines = std::map<std::int64_t, CrackLine>;  // of a fracture's cracks, by bond

// The cracks on the way from a domain over these bonds, at distances from `begin` [m] on.
std::vector<FracturePoint> along(const std::vector<std::int64_t>& bonds, std::int32_t start, double begin,
                                 const Lines& lines, const Network& n, const Options& o) {
  std::vector<FracturePoint> points;
  double way = begin;
  auto at = start;
  for (const auto bond : bonds) {
    const CrackLine& crack = lines.at(bond);
    const auto next = n.left[bond] == at ? n.right[bond] : n.left[bond];
    const double before = FractureGraph::leg(n, at, bond, crack.middle),
                 after = FractureGraph::leg(n, next, bond, crack.middle);
    FracturePoint p{};
    p.bond = bond;
    p.at = crack.middle;
    p.distance = way + before;
    p.length = before + after;
    p.aperture = crack.aperture;
    p.wing = -1;
    if (!n.pressure.empty()) {
      p.hydraulic_aperture = n.aperture_of(static_cast<std::size_t>(bond));
      p.pressure = 0.5 * (n.pressure[at] + n.pressure[next]);
      p.saturation =
          0.5 * (saturation_of(n, at, o.fluid_bulk_modulus) + saturation_of(n, next, o.fluid_bulk_modulus));
    }
    points.push_back(p);
    way += before + after;
    at = next;
  }
  points.back().tip = true;
  return points;
}

// Whether a way leads to smaller x, or y if it stands upright.
bool leads_back(Vec2 way) {
  return std::abs(way.x) >= std::abs(way.y) ? way.x < 0.0 : way.y < 0.0;
}

}  // namespace

std::vector<FracturePoint> fracture_line(const Assembly& a, const Network& n, const Options& o,
                                         const std::vector<WellPlace>& wells, const CrackLog& log,
                                         std::int32_t fracture) {
  FractureGraph graph;
  Lines lines;
  for (const Crack& crack : log) {
    if (crack.fracture != fracture) continue;
    const CrackLine line = crack_line(n, a, o, crack.bond);
    lines.emplace(crack.bond, line);
    graph.add(n, crack.bond, line.middle);
  }
  if (lines.empty()) return {};
  const auto well =
      std::find_if(wells.begin(), wells.end(), [&](const auto& w) { return graph.holds(w.domain); });
  if (well == wells.end()) {
    const auto [from, to] = graph.ends();
    const auto ways = graph.shortest_from(from);
    const auto bonds = FractureGraph::bonds_to(ways, to);
    if (bonds.empty()) return {};  // a pore with itself on both sides
    auto line = along(bonds, from, -0.5 * ways.at(to).length, lines, n, o);
    line.front().tip = true;
    return line;
  }
  const auto ways = graph.shortest_from(well->domain);
  auto ends = graph.wings(ways, well->domain);
  if (ends.empty()) return {};
  ends.resize(std::min<std::size_t>(2, ends.size()));
  // The line runs the way of growing x or y.
  const auto place = [&](std::int32_t end) { return lines.at(ways.at(end).bond).middle; };
  if (ends.size() == 2 && leads_back(place(ends[1]) - place(ends[0]))) std::swap(ends[0], ends[1]);
  std::vector<FracturePoint> line;
  for (const auto end : ends) {
    const auto bonds = FractureGraph::bonds_to(ways, end);
    const Vec2 mouth = lines.at(bonds.front()).middle - well->centre;
    auto wing = along(bonds, well->domain, norm(mouth), lines, n, o);
    const bool first = ends.size() == 2 ? end == ends[0] : leads_back(place(end) - well->centre);
    for (auto& p : wing) {
      p.wing = first ? 0 : 1;
      if (first) p.distance = -p.distance;
    }
    if (first) std::reverse(wing.begin(), wing.end());
    line.insert(line.end(), wing.begin(), wing.end());
  }
  return line;
}

}  // namespace hfrac
