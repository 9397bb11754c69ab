// SPDX-License-Identifier: BSD-3-Clause
#include "frac/catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace hfrac {
namespace {

using Members = std::vector<std::size_t>;

void add_couple(const CatalogueCrack& crack, double thickness, SeismicEvent& event) {
  const Vec2 n = crack.normal, t{-n.y, n.x};
  const Vec2 force = crack.normal_force * n + crack.shear_force * t;
  const double arm = thickness * crack.distance;
  event.xx += arm * force.x * n.x;
  event.yy += arm * force.y * n.y;
  event.xy += 0.5 * arm * (force.x * n.y + force.y * n.x);
}

SeismicEvent event_of_members(std::span<const CatalogueCrack> cracks, const Members& members,
                              double thickness) {
  SeismicEvent event;
  event.first_crack = static_cast<std::int64_t>(members.front());
  event.crack_count = static_cast<std::int64_t>(members.size());
  event.time = cracks[members.front()].time;
  event.first_cycle = event.last_cycle = cracks[members.front()].cycle;
  for (const auto c : members) {
    const CatalogueCrack& crack = cracks[c];
    event.tensile_cracks += crack.tensile ? 1 : 0;
    event.first_cycle = std::min(event.first_cycle, crack.cycle);
    event.last_cycle = std::max(event.last_cycle, crack.cycle);
    event.duration = std::max(event.duration, crack.time - event.time);
    event.position = event.position + crack.position;
    event.energy += thickness * crack.energy;
    event.length += crack.length;
    add_couple(crack, thickness, event);
  }
  event.position = (1.0 / static_cast<double>(members.size())) * event.position;
  for (const auto c : members) {
    const Vec2 arm = cracks[c].position - event.position;
    event.radius = std::max(event.radius, norm(arm));
  }
  rate_strength(event);
  return event;
}

}  // namespace

std::vector<SeismicEvent> find_events(std::span<const CatalogueCrack> cracks, const CatalogueRule& rule,
                                      std::vector<std::int64_t>& event_of) {
  std::vector<Source> sources;
  sources.reserve(cracks.size());
  for (const auto& crack : cracks)
    sources.push_back({crack.position, crack.distance, crack.time, crack.cycle});
  event_of.assign(cracks.size(), -1);
  std::vector<SeismicEvent> events;
  for (const auto& members : linked_sources(sources, rule.link)) {
    for (const auto c : members) event_of[c] = static_cast<std::int64_t>(events.size());
    events.push_back(event_of_members(cracks, members, rule.thickness));
  }
  return events;
}

// Completeness where not given: the fullest tenth of a magnitude (maximum curvature, Wiemer and Wyss 2000). The slope
// is the likelihood's, b = log10 e / (mean - completeness), and its standard error b / sqrt(N) (Aki 1965).
MagnitudeLaw magnitude_law(std::span<const double> magnitudes, double completeness) {
  MagnitudeLaw law;
  if (std::isnan(completeness)) {
    std::map<double, std::int64_t> tenths;
    for (const double magnitude : magnitudes) {
      if (std::isfinite(magnitude)) ++tenths[std::floor(10.0 * magnitude)];
    }
    std::int64_t most = 0;
    completeness = 0.0;
    for (const auto& [tenth, count] : tenths) {
      if (count <= most) continue;
      most = count;
      completeness = tenth / 10.0;
    }
  }
  law.completeness = completeness;
  double above = 0.0;
  for (const double magnitude : magnitudes) {
    if (!std::isfinite(magnitude) || magnitude < completeness) continue;
    above += magnitude - completeness;
    ++law.count;
  }
  if (law.count < 2 || !(above > 0.0)) return law;
  const auto count = static_cast<double>(law.count);
  law.b = std::numbers::log10e * count / above;
  law.b_error = law.b / std::sqrt(count);
  law.a = std::log10(count) + law.b * completeness;
  return law;
}

}  // namespace hfrac
