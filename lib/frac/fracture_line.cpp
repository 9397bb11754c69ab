// SPDX-License-Identifier: BSD-3-Clause
#include "frac/fracture_line.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>

#include "frac/fractures.hpp"

namespace hfrac {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

// Domains of one fracture, the cracks between them, and the shortest ways from one of them.
struct Ways {
  struct Edge {
    std::int32_t to;
    std::int64_t bond;
    double way;  // m
  };
  std::map<std::int32_t, std::vector<Edge>> edges;
  struct Reached {
    double way = unreached;
    std::int32_t from = -1, start = -1;  // domain before it; first one after the start
    std::int64_t bond = -1;
  };
  std::map<std::int32_t, Reached> reached;

  void find(std::int32_t from) {
    reached.clear();
    reached[from].way = 0.0;
    using Item = std::pair<double, std::int32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
    open.emplace(0.0, from);
    while (!open.empty()) {
      const auto [way, at] = open.top();
      open.pop();
      if (way > reached[at].way) continue;
      for (const Edge& edge : edges[at]) {
        Reached& next = reached[edge.to];
        if (way + edge.way >= next.way) continue;
        next = {way + edge.way, at, at == from ? edge.to : reached[at].start, edge.bond};
        open.emplace(next.way, edge.to);
      }
    }
  }
  // The farthest domain but those on the side of `without`.
  [[nodiscard]] std::int32_t farthest(std::int32_t without) const {
    std::int32_t best = -1;
    double way = 0.0;
    for (const auto& [domain, at] : reached) {
      if (at.start < 0 || at.start == without || !(at.way > way)) continue;
      best = domain;
      way = at.way;
    }
    return best;
  }
  // Bonds from the start to that domain, and the middle of each along the way [m].
  [[nodiscard]] std::vector<std::int64_t> bonds_to(std::int32_t domain) const {
    std::vector<std::int64_t> bonds;
    for (auto at = domain; reached.at(at).bond >= 0; at = reached.at(at).from)
      bonds.push_back(reached.at(at).bond);
    std::reverse(bonds.begin(), bonds.end());
    return bonds;
  }
};

double distance(Vec2 a, Vec2 b) {
  return std::sqrt(dot(a - b, a - b));
}

}  // namespace

std::vector<FracturePoint> fracture_line(const Assembly& a, const Network& n, const Options& o,
                                         const std::vector<WellPlace>& wells, const CrackLog& log,
                                         std::int32_t fracture) {
  Ways ways;
  // From pore to pore through the contact; at a hole the way begins at the contact.
  const auto leg = [&](std::int32_t domain, Vec2 middle) {
    return n.kind[domain] == DomainKind::rock ? distance(n.centroid[domain], middle) : 0.0;
  };
  std::map<std::int64_t, CrackLine> lines;
  for (const Crack& crack : log) {
    if (crack.fracture != fracture) continue;
    const auto l = n.left[crack.bond], r = n.right[crack.bond];
    const CrackLine line = crack_line(n, a, o, crack.bond);
    const double way = leg(l, line.middle) + leg(r, line.middle);
    lines.emplace(crack.bond, line);
    if (l == r) continue;
    ways.edges[l].push_back({r, crack.bond, way});
    ways.edges[r].push_back({l, crack.bond, way});
  }
  if (ways.edges.empty()) return {};
  const WellPlace* well = nullptr;
  for (const auto& w : wells)
    if (well == nullptr && ways.edges.count(w.domain) > 0) well = &w;

  std::vector<FracturePoint> line;
  // Adds what lies between the start and a domain, `sign` times its distances from the start's.
  const auto add = [&](std::int32_t start, std::int32_t end, double begin, double sign, std::int32_t wing) {
    double way = begin;
    auto at = start;
    for (const auto bond : ways.bonds_to(end)) {
      const CrackLine& crack = lines.at(bond);
      const auto next = n.left[bond] == at ? n.right[bond] : n.left[bond];
      way += leg(at, crack.middle);
      FracturePoint p{};
      p.bond = bond;
      p.at = crack.middle;
      p.distance = sign * way;
      p.length = leg(at, crack.middle) + leg(next, crack.middle);
      p.aperture = crack.aperture;
      p.wing = wing;
      if (!n.pressure.empty()) {
        p.hydraulic_aperture = n.aperture_of(static_cast<std::size_t>(bond));
        p.pressure = 0.5 * (n.pressure[at] + n.pressure[next]);
        p.saturation =
            0.5 * (saturation_of(n, at, o.fluid_bulk_modulus) + saturation_of(n, next, o.fluid_bulk_modulus));
      }
      line.push_back(p);
      way += leg(next, crack.middle);
      at = next;
    }
    line.back().tip = true;
  };

  if (well == nullptr) {
    ways.find(ways.edges.begin()->first);
    const auto from = ways.farthest(-1);
    ways.find(from);
    const auto to = ways.farthest(-1);
    add(from, to, -0.5 * ways.reached.at(to).way, 1.0, -1);
    line.front().tip = true;
    return line;
  }
  ways.find(well->domain);
  const auto one = ways.farthest(-1);
  const auto other = ways.farthest(ways.reached.at(one).start);
  // The line runs the way of growing x, or y where it stands upright.
  std::vector<std::int32_t> ends{one};
  if (other >= 0) ends.push_back(other);
  const auto goes_back = [&](std::int32_t end) {
    const Vec2 to = n.centroid[end] - well->centre;
    return std::abs(to.x) >= std::abs(to.y) ? to.x < 0.0 : to.y < 0.0;
  };
  if (ends.size() == 2 ? !goes_back(ends[0]) && goes_back(ends[1]) : false) std::swap(ends[0], ends[1]);
  const bool first_back = ends.size() == 2 || goes_back(ends[0]);
  const auto begin = [&](std::int32_t end) {
    return distance(lines.at(ways.bonds_to(end).front()).middle, well->centre);
  };
  add(well->domain, ends[0], begin(ends[0]), first_back ? -1.0 : 1.0, first_back ? 0 : 1);
  if (first_back) std::reverse(line.begin(), line.end());
  if (ends.size() == 2) add(well->domain, ends[1], begin(ends[1]), 1.0, 1);
  return line;
}

}  // namespace hfrac
