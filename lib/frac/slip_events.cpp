// SPDX-License-Identifier: BSD-3-Clause
#include "frac/slip_events.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace hfrac {
namespace {

void add_double_couple(const CatalogueSlip& slip, double thickness, SeismicEvent& event) {
  const Vec2 n = slip.normal, t{-n.y, n.x};
  const double moment = slip.shear_modulus * thickness * slip.length * slip.slip;
  event.xx += 2.0 * moment * t.x * n.x;
  event.yy += 2.0 * moment * t.y * n.y;
  event.xy += moment * (t.x * n.y + t.y * n.x);
}

SeismicEvent event_of_members(std::span<const CatalogueSlip> slips, const std::vector<std::size_t>& members,
                              double thickness) {
  SeismicEvent event;
  event.kind = EventKind::slip;
  event.first_slip = slips[members.front()].id;
  event.slip_count = static_cast<std::int64_t>(members.size());
  event.time = slips[members.front()].time;
  double swept = 0.0;                      // m2, length times slip
  std::map<std::int64_t, double> lengths;  // m, by contact: each counts once
  for (const auto k : members) {
    const CatalogueSlip& slip = slips[k];
    event.duration = std::max(event.duration, slip.time - event.time);
    event.position = event.position + slip.position;
    swept += slip.length * std::abs(slip.slip);
    lengths[slip.bond] = slip.length;
    add_double_couple(slip, thickness, event);
  }
  for (const auto& [bond, length] : lengths) event.length += length;
  if (event.length > 0.0) event.slip = swept / event.length;
  event.position = (1.0 / static_cast<double>(members.size())) * event.position;
  for (const auto k : members) {
    const Vec2 arm = slips[k].position - event.position;
    event.radius = std::max(event.radius, norm(arm));
  }
  rate_strength(event);
  return event;
}

}  // namespace

std::vector<SeismicEvent> find_slip_events(std::span<const CatalogueSlip> slips, const SlipRule& rule) {
  std::vector<CatalogueSlip> fast;
  std::vector<Source> sources;
  for (const auto& slip : slips) {
    if (std::abs(slip.slip) < rule.slip_rate * slip.duration) continue;
    fast.push_back(slip);
    sources.push_back({slip.position, slip.disc_distance, slip.time, 0});
  }
  std::vector<SeismicEvent> events;
  for (const auto& members : linked_sources(sources, rule.link))
    events.push_back(event_of_members(fast, members, rule.thickness));
  return events;
}

}  // namespace hfrac
