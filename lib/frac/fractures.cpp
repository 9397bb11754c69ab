// SPDX-License-Identifier: BSD-3-Clause
#include "frac/fractures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "frac/facets.hpp"
#include "frac/fracture_graph.hpp"
#include "solid/bond_law.hpp"

namespace hfrac {
namespace {

double largest_distance(std::vector<Vec2> points) {
  // On the convex hull (Andrew's monotone chain), where the farthest pair lies.
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Vec2> hull(2 * points.size() + 1);
  std::size_t k = 0;
  const auto add = [&](Vec2 p, std::size_t least) {
    while (k >= least && cross(hull[k - 1] - hull[k - 2], p - hull[k - 1]) <= 0.0) --k;
    hull[k++] = p;
  };
  for (const auto& p : points) add(p, 2);
  const std::size_t lower = k + 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
  double best = 0.0;
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = i + 1; j < k; ++j) best = std::max(best, dot(hull[i] - hull[j], hull[i] - hull[j]));
  }
  return std::sqrt(best);
}

// Direction of largest spread, -pi/2 to pi/2, about `centre`.
double main_direction(const std::vector<Vec2>& points, Vec2 centre) {
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (const auto& p : points) {
    const Vec2 d = p - centre;
    xx += d.x * d.x;
    yy += d.y * d.y;
    xy += d.x * d.y;
  }
  return 0.5 * std::atan2(2.0 * xy, xx - yy);
}

struct Sets {
  std::vector<std::int32_t> parent;
  explicit Sets(std::size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), 0); }
  std::int32_t root(std::int32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = root(a);
    b = root(b);
    parent[std::max(a, b)] = std::min(a, b);
  }
};

}  // namespace

CrackLine crack_line(const Assembly& a, const Options& o, std::int64_t bond) {
  const BondView view = view_bond(a, o, bond);
  const auto i = a.first[bond], j = a.second[bond];
  const double share = a.radius[i] / (a.radius[i] + a.radius[j]);
  const Vec2 from = a.position(i), to = a.position(j);
  return {from + share * (to - from), view.normal, 2.0 * a.bond_radius(bond), std::max(0.0, view.gap)};
}

CrackLine crack_line(const Network& n, const Assembly& a, const Options& o, std::int64_t bond) {
  CrackLine line = crack_line(a, o, bond);
  if (const CrackPlane* plane = n.planes.of(static_cast<std::size_t>(bond)))
    line.aperture = std::max(0.0, CrackPlanes::opening(*plane, a, static_cast<std::size_t>(bond)));
  if (!n.facet_opening.empty()) line.aperture = n.facet_opening[bond];
  return line;
}

double farthest_tip(const Assembly& a, const Network& n, const Options& o,
                    const std::vector<WellPlace>& wells, const CrackLog& log) {
  std::map<std::int32_t, std::vector<std::size_t>> at;  // cracks by domain
  for (std::size_t c = 0; c < log.size(); ++c) {
    for (const auto d : {n.left[log[c].bond], n.right[log[c].bond]}) at[d].push_back(c);
  }
  double farthest = 0.0;
  for (const auto& well : wells) {
    std::vector<char> seen(log.size(), 0);
    std::vector<std::int32_t> open{well.domain};
    while (!open.empty()) {
      const auto d = open.back();
      open.pop_back();
      const auto here = at.find(d);
      if (d == 0 || here == at.end()) continue;  // the outside joins nothing
      for (const auto c : here->second) {
        if (seen[c] != 0) continue;
        seen[c] = 1;
        const auto bond = log[c].bond;
        const CrackLine line = crack_line(a, o, bond);
        const Vec2 along{-0.5 * line.length * line.normal.y, 0.5 * line.length * line.normal.x};
        for (const Vec2 from : {line.middle + along - well.centre, line.middle - along - well.centre})
          farthest = std::max(farthest, norm(from));
        open.push_back(n.left[bond] == d ? n.right[bond] : n.left[bond]);
      }
    }
  }
  return farthest;
}

std::vector<Fracture> find_fractures(const Assembly& a, const Network& n, const Options& o,
                                     const std::vector<WellPlace>& wells, CrackLog& log,
                                     const Facets* facets) {
  const auto cracks = static_cast<std::int32_t>(log.size());
  Sets sets(log.size());
  std::map<std::int32_t, std::int32_t> first_in_domain;  // ordered: results do not depend on hashing
  for (std::int32_t c = 0; c < cracks; ++c) {
    for (const auto d : {n.left[log[c].bond], n.right[log[c].bond]}) {
      if (d == 0) continue;  // the outside joins nothing
      const auto [at, fresh] = first_in_domain.emplace(d, c);
      if (!fresh) sets.join(at->second, c);
    }
  }
  std::map<std::int32_t, std::vector<std::int32_t>> groups;
  for (std::int32_t c = 0; c < cracks; ++c) groups[sets.root(c)].push_back(c);
  std::vector<std::vector<std::int32_t>> ordered;
  ordered.reserve(groups.size());
  for (auto& [root, members] : groups) ordered.push_back(std::move(members));
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto& p, const auto& q) { return p.size() > q.size(); });

  std::vector<Fracture> fractures;
  for (const auto& members : ordered) {
    Fracture f;
    FractureGraph graph;
    std::vector<Vec2> ends;
    Vec2 centre{};
    double length_sum = 0.0, pressure_sum = 0.0;
    for (const auto c : members) {
      log.set_fracture(static_cast<std::size_t>(c), static_cast<std::int32_t>(fractures.size()));
      const auto bond = log[c].bond;
      const CrackLine line = crack_line(n, a, o, bond);
      // What it stands for of the fracture's length.
      const auto e = static_cast<std::size_t>(bond);
      double length = n.planes.of(e) != nullptr ? pipe_length(n, a, e) : line.length;
      double opening = line.aperture;
      if (const auto facet = facets != nullptr ? facets->of(bond) : -1; facet >= 0) {
        const Facet& face = facets->all()[facet];
        length = face.length;
        opening = std::max(0.0, facets->opening(a, n, face));
      }
      const Vec2 along{-line.normal.y, line.normal.x};
      ends.push_back(line.middle + (0.5 * line.length) * along);
      ends.push_back(line.middle - (0.5 * line.length) * along);
      centre = centre + line.middle;
      ++f.crack_count;
      f.tensile_cracks += log[c].mode == CrackMode::tension ? 1 : 0;
      f.largest_aperture = std::max(f.largest_aperture, line.aperture);
      f.volume += opening * length;
      length_sum += length;
      const auto l = n.left[bond], r = n.right[bond];
      pressure_sum += 0.5 * (n.pressure[l] + n.pressure[r]);
      graph.add(n, bond, line.middle);
    }
    const auto count = static_cast<double>(f.crack_count);
    centre = (1.0 / count) * centre;
    f.mean_aperture = f.volume / length_sum;
    f.mean_pressure = pressure_sum / count;
    f.extent = largest_distance(ends);
    for (std::size_t w = 0; w < wells.size() && f.well < 0; ++w) {
      if (graph.holds(wells[w].domain)) f.well = static_cast<std::int64_t>(w);
    }
    if (f.well >= 0) {
      const WellPlace& well = wells[static_cast<std::size_t>(f.well)];
      const auto ways = graph.shortest_from(well.domain);
      const auto wings = graph.wings(ways, well.domain);
      f.wings = static_cast<std::int64_t>(wings.size());
      for (std::size_t k = 0; k < std::min<std::size_t>(2, wings.size()); ++k)
        f.length += ways.at(wings[k]).length;
      for (const auto& p : ends) f.reach = std::max(f.reach, norm(p - well.centre) - well.equivalent_radius);
      f.azimuth = main_direction(ends, well.centre);
    } else {
      const auto [from, to] = graph.ends();
      f.length = graph.shortest_from(from).at(to).length;
      f.wings = 1;
      f.azimuth = main_direction(ends, centre);
    }
    fractures.push_back(f);
  }
  return fractures;
}

}  // namespace hfrac
