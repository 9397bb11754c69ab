// SPDX-License-Identifier: BSD-3-Clause
#include "frac/catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

namespace hfrac {
namespace {

using Members = std::vector<std::size_t>;

// Whose cracks belong together; the smallest number of a set stands for it.
struct Links {
  std::vector<std::size_t> parent;
  explicit Links(std::size_t count) : parent(count) { std::iota(parent.begin(), parent.end(), 0); }
  std::size_t root(std::size_t c) {
    while (parent[c] != c) c = parent[c] = parent[parent[c]];
    return c;
  }
  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    parent[std::max(a, b)] = std::min(a, b);
  }
};

double linking_distance(std::span<const CatalogueCrack> cracks, const CatalogueRule& rule) {
  if (rule.distance > 0.0 || cracks.empty()) return rule.distance;
  double sum = 0.0;
  for (const auto& crack : cracks) sum += crack.distance;
  return 2.0 * sum / static_cast<double>(cracks.size());
}

bool linked(const CatalogueCrack& p, const CatalogueCrack& q, double distance, const CatalogueRule& rule) {
  const Vec2 between = p.position - q.position;
  return dot(between, between) <= distance * distance && std::abs(p.time - q.time) <= rule.time_window &&
         (rule.cycle_window == 0 || std::abs(p.cycle - q.cycle) <= rule.cycle_window);
}

// Cells as wide as the linking distance: who may be linked to a crack lies in its own or a neighbouring one.
Links link(std::span<const CatalogueCrack> cracks, const CatalogueRule& rule) {
  const double distance = linking_distance(cracks, rule);
  Links links(cracks.size());
  std::map<std::pair<double, double>, Members> cells;  // ordered: results do not depend on hashing
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    const double column = distance > 0.0 ? std::floor(cracks[c].position.x / distance) : cracks[c].position.x;
    const double row = distance > 0.0 ? std::floor(cracks[c].position.y / distance) : cracks[c].position.y;
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        const auto cell = cells.find({column + i, row + j});
        if (cell == cells.end()) continue;
        for (const auto other : cell->second) {
          if (linked(cracks[other], cracks[c], distance, rule)) links.join(other, c);
        }
      }
    }
    cells[{column, row}].push_back(c);
  }
  return links;
}

void add_couple(const CatalogueCrack& crack, double thickness, SeismicEvent& event) {
  const Vec2 n = crack.normal, t{-n.y, n.x};
  const Vec2 force = crack.normal_force * n + crack.shear_force * t;
  const double arm = thickness * crack.distance;
  event.xx += arm * force.x * n.x;
  event.yy += arm * force.y * n.y;
  event.xy += 0.5 * arm * (force.x * n.y + force.y * n.x);
}

// Scalar moment: Silver and Jordan (1982), sqrt(m_ij m_ij / 2). Its magnitude: Hanks and Kanamori (1979), 2/3 log10
// M0 - 10.7 with M0 in dyn cm. Energy magnitude: Choy and Boatwright (1995). Isotropic share: Feignier and Young
// (1992), trace over the sum of trace and deviatoric eigenvalues, here in the plane.
void rate_strength(SeismicEvent& event) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  constexpr double dyne_centimetres = 1e7;  // per N m
  event.moment = std::sqrt(0.5 * (event.xx * event.xx + event.yy * event.yy) + event.xy * event.xy);
  event.magnitude =
      event.moment > 0.0 ? 2.0 / 3.0 * std::log10(dyne_centimetres * event.moment) - 10.7 : nothing;
  event.energy_magnitude = event.energy > 0.0 ? 2.0 / 3.0 * std::log10(event.energy) - 2.9 : nothing;
  const double trace = event.xx + event.yy;
  const double deviator = std::hypot(0.5 * (event.xx - event.yy), event.xy);
  const double all = std::abs(trace) + 2.0 * deviator;
  event.isotropic_fraction = all > 0.0 ? trace / all : 0.0;
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
    event.position = event.position + crack.position;
    event.energy += thickness * crack.energy;
    event.length += crack.length;
    add_couple(crack, thickness, event);
  }
  event.position = (1.0 / static_cast<double>(members.size())) * event.position;
  for (const auto c : members) {
    const Vec2 arm = cracks[c].position - event.position;
    event.radius = std::max(event.radius, std::sqrt(dot(arm, arm)));
  }
  rate_strength(event);
  return event;
}

}  // namespace

std::vector<SeismicEvent> find_events(std::span<const CatalogueCrack> cracks, const CatalogueRule& rule,
                                      std::vector<std::int64_t>& event_of) {
  Links links = link(cracks, rule);
  std::map<std::size_t, Members> groups;  // by first crack
  for (std::size_t c = 0; c < cracks.size(); ++c) groups[links.root(c)].push_back(c);
  event_of.assign(cracks.size(), -1);
  std::vector<SeismicEvent> events;
  events.reserve(groups.size());
  for (const auto& [first, members] : groups) {
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
