// SPDX-License-Identifier: BSD-3-Clause
#include "step/added_well.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "host/quad.hpp"
#include "step/host_state.hpp"
#include "step/rest.hpp"

namespace hfrac {
namespace {

// Centres of the discs around a domain, at bonding.
std::vector<Vec2> polygon_of(const Model& m, std::int32_t d) {
  const Network& n = m.network;
  std::vector<Vec2> polygon;
  for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k)
    polygon.push_back({m.assembly.x[n.corner_disc[k]], m.assembly.y[n.corner_disc[k]]});
  return polygon;
}

bool lies_in(const std::vector<Vec2>& polygon, Vec2 at) {
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) * (b.x - a.x) / (b.y - a.y))
      inside = !inside;
  }
  return inside;
}

[[noreturn]] void refuse(Vec2 at, const std::string& why) {
  throw Error(ErrorKind::argument, "no well can be added at " + place_text(at) + ": " + why);
}

std::int32_t pore_nearest_to(const Model& m, Vec2 at) {
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) refuse(at, "give two finite numbers.");
  const Network& n = m.network;
  if (!lies_in(polygon_of(m, 0), at)) refuse(at, "it lies outside the rock; give a place among its discs.");
  std::int32_t nearest = 1;
  const auto way = [&](std::int32_t d) { return norm(n.centroid[d] - at); };
  for (std::int32_t d = 2; d < n.domain_count(); ++d)
    if (way(d) < way(nearest)) nearest = d;
  for (std::size_t w = 0; w < m.wells.size(); ++w) {
    const auto d = m.wells[w].place.domain;
    if (d == nearest || (w < m.well_count && lies_in(polygon_of(m, d), at)))
      refuse(at, "well " + std::to_string(w) + ", at " + place_text(m.wells[w].place.centre) +
                     ", is there already; drive that one, or give a place in the rock beside it.");
  }
  return nearest;
}

}  // namespace

std::size_t add_well(Simulation& s, Vec2 at) {
  Engine& e = s.engine();
  if (!e.wet())
    refuse(at, "flow.scheme is \"off\", so pores hold no fluid; use \"implicit\" or \"explicit\".");
  require_no_open_step(s, "further wells");
  Model& m = e.model;
  const auto d = pore_nearest_to(m, at);
  Well well;
  well.place = {m.network.centroid[d], std::sqrt(area_of(polygon_of(m, d)) / std::numbers::pi), d};
  well.drive.control = WellControl::rate;
  well.content = m.network.content[d];
  // Its fluid, with the heat in it, is no longer the rock's.
  const double before = e.heat ? stored_heat(e) : 0.0;
  s.take_well(well);
  if (e.heat) m.heat->from_wells += stored_heat(e) - before;
  if (!m.network.second_content.empty()) m.accounts.second.from_wells -= m.network.second_content[d];
  return m.wells.size() - 1;
}

}  // namespace hfrac
