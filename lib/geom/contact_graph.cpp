// SPDX-License-Identifier: BSD-3-Clause
#include "geom/contact_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "geom/cell_grid.hpp"

namespace hfrac {
namespace {

struct Join {
  std::int32_t i, j;
  double gap;  // m
  bool bonded = true;
};

// Only a host's own discs can be like this.
[[noreturn]] void refuse_overlap(std::int32_t i, std::int32_t j, double x, double y) {
  throw Error(ErrorKind::model,
              "discs " + std::to_string(i) + " and " + std::to_string(j) + " near (" + std::to_string(x) +
                  ", " + std::to_string(y) +
                  ") m overlap by more than the larger one's radius; give discs that at most touch");
}

std::vector<Join> near_pairs(const Array<double>& x, const Array<double>& y, const Array<double>& radius,
                             double mean_radius, const Grading& sizes, double gap_tolerance) {
  const double largest = *std::max_element(radius.begin(), radius.end());
  const double widest = gap_tolerance * (sizes.graded() ? sizes.coarsest() : mean_radius);
  const CellGrid grid(x, y, 2.0 * largest + widest);
  std::vector<Join> joins;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(x.size()); ++i) {
    const auto begin = joins.size();
    grid.near(x[i], y[i], radius[i] + largest + widest, [&](std::int32_t j) {
      if (j <= i) return;
      const double dx = x[j] - x[i], dy = y[j] - y[i];
      const double gap = std::sqrt(dx * dx + dy * dy) - radius[i] - radius[j];
      if (gap < -std::max(radius[i], radius[j])) refuse_overlap(i, j, x[i], y[i]);
      const double tolerance =
          sizes.graded() ? gap_tolerance * sizes.at({x[i] + 0.5 * dx, y[i] + 0.5 * dy}) : widest;
      if (gap < tolerance) joins.push_back({i, j, gap});
    });
    std::sort(joins.begin() + static_cast<std::ptrdiff_t>(begin), joins.end(),
              [](const Join& a, const Join& b) { return a.j < b.j; });
  }
  return joins;
}

bool segments_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p); };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

// Marks which near pairs a host's list bonds, and adds those of the list that are not near. `number`: of each disc given among
// those kept, -1 if a well removed it.
void apply_bonds(const Array<double>& x, const Array<double>& y, const Array<double>& radius,
                 std::span<const std::int64_t> bonds, const std::vector<std::int32_t>& number,
                 std::vector<Join>& joins) {
  const auto before = [](const Join& a, const Join& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; };
  std::vector<Join> listed;
  listed.reserve(bonds.size() / 2);
  for (std::size_t k = 0; k + 1 < bonds.size(); k += 2) {
    auto i = number[static_cast<std::size_t>(bonds[k])], j = number[static_cast<std::size_t>(bonds[k + 1])];
    if (i < 0 || j < 0) continue;
    if (i > j) std::swap(i, j);
    const double dx = x[j] - x[i], dy = y[j] - y[i];
    listed.push_back({i, j, std::sqrt(dx * dx + dy * dy) - radius[i] - radius[j]});
  }
  std::sort(listed.begin(), listed.end(), before);
  std::vector<Join> all;
  all.reserve(std::max(joins.size(), listed.size()));
  auto near = joins.begin();
  for (const auto& bond : listed) {
    for (; near != joins.end() && before(*near, bond); ++near)
      all.push_back({near->i, near->j, near->gap, false});
    if (near != joins.end() && !before(bond, *near)) ++near;
    all.push_back(bond);
  }
  for (; near != joins.end(); ++near) all.push_back({near->i, near->j, near->gap, false});
  joins.swap(all);
}

// Removes one of each crossing pair: that without a bond, otherwise the wider. Returns how many went.
std::int64_t remove_crossings(const Array<double>& x, const Array<double>& y, double largest,
                              std::vector<Join>& joins) {
  Array<double> mx(joins.size()), my(joins.size());
  for (std::size_t e = 0; e < joins.size(); ++e) {
    mx[e] = 0.5 * (x[joins[e].i] + x[joins[e].j]);
    my[e] = 0.5 * (y[joins[e].i] + y[joins[e].j]);
  }
  double reach = 2.2 * largest;  // two edges whose middles are farther apart than the longest cannot cross
  for (const auto& join : joins) reach = std::max(reach, join.gap + 2.0 * largest);
  const CellGrid grid(mx, my, 2.0 * largest);
  std::vector<char> gone(joins.size(), 0);
  for (std::int32_t e = 0; e < static_cast<std::int32_t>(joins.size()); ++e) {
    grid.near(mx[e], my[e], reach, [&](std::int32_t f) {
      if (f <= e || gone[e] || gone[f]) return;
      const Join &a = joins[e], &b = joins[f];
      if (a.i == b.i || a.i == b.j || a.j == b.i || a.j == b.j) return;
      if (segments_cross({x[a.i], y[a.i]}, {x[a.j], y[a.j]}, {x[b.i], y[b.i]}, {x[b.j], y[b.j]})) {
        const bool first_goes = a.bonded != b.bonded ? b.bonded : a.gap > b.gap;
        gone[first_goes ? e : f] = 1;
      }
    });
  }
  std::vector<Join> kept;
  kept.reserve(joins.size());
  for (std::size_t e = 0; e < joins.size(); ++e) {
    if (!gone[e]) kept.push_back(joins[e]);
  }
  const auto removed = static_cast<std::int64_t>(joins.size() - kept.size());
  joins.swap(kept);
  return removed;
}

// Marks discs with fewer than two joins, again and again, then all but the largest connected piece.
std::vector<char> discs_held(std::size_t n, const std::vector<Join>& joins) {
  std::vector<std::int32_t> degree(n, 0), start(n + 1, 0), other(2 * joins.size());
  for (const auto& join : joins) {
    ++degree[join.i];
    ++degree[join.j];
  }
  for (std::size_t i = 0; i < n; ++i) start[i + 1] = start[i] + degree[i];
  auto cursor = start;
  for (const auto& join : joins) {
    other[cursor[join.i]++] = join.j;
    other[cursor[join.j]++] = join.i;
  }
  std::vector<char> held(n, 1);
  std::vector<std::int32_t> stack;
  for (std::size_t i = 0; i < n; ++i) {
    if (degree[i] < 2) stack.push_back(static_cast<std::int32_t>(i));
  }
  while (!stack.empty()) {
    const auto i = stack.back();
    stack.pop_back();
    if (!held[i]) continue;
    held[i] = 0;
    for (auto k = start[i]; k < start[i + 1]; ++k) {
      if (held[other[k]] && --degree[other[k]] < 2) stack.push_back(other[k]);
    }
  }
  std::vector<std::int32_t> piece(n, -1), size;
  for (std::size_t seed = 0; seed < n; ++seed) {
    if (!held[seed] || piece[seed] >= 0) continue;
    const auto number = static_cast<std::int32_t>(size.size());
    size.push_back(0);
    stack.assign(1, static_cast<std::int32_t>(seed));
    piece[seed] = number;
    while (!stack.empty()) {
      const auto i = stack.back();
      stack.pop_back();
      ++size[number];
      for (auto k = start[i]; k < start[i + 1]; ++k) {
        if (held[other[k]] && piece[other[k]] < 0) {
          piece[other[k]] = number;
          stack.push_back(other[k]);
        }
      }
    }
  }
  if (size.empty()) return held;
  const auto largest = static_cast<std::int32_t>(std::max_element(size.begin(), size.end()) - size.begin());
  for (std::size_t i = 0; i < n; ++i) held[i] = piece[i] == largest ? 1 : 0;
  return held;
}

// Edges by parts: those inside a tile in the order that keeps additions apart, those across by pair of tiles.
void number_edges(std::vector<Join>& joins, ContactGraph& graph) {
  const auto tile_of = [](std::int32_t disc) { return static_cast<std::size_t>(disc / tile_size); };
  const auto across = [&](const Join& join) { return tile_of(join.i) != tile_of(join.j); };
  const std::size_t tiles = (graph.x.size() + tile_size - 1) / tile_size;
  std::stable_sort(joins.begin(), joins.end(), [&](const Join& a, const Join& b) {
    if (across(a) != across(b)) return across(b);
    return tile_of(a.i) != tile_of(b.i) ? tile_of(a.i) < tile_of(b.i) : tile_of(a.j) < tile_of(b.j);
  });
  graph.part_first_edge.assign(tiles + 1, 0);
  graph.tile_first_pair.assign(tiles + 1, 0);
  auto& first = graph.part_first_edge;
  for (std::size_t e = 0; e < joins.size(); ++e) {
    const Join& join = joins[e];
    if (!across(join)) {
      ++first[tile_of(join.i) + 1];
      continue;
    }
    const bool known =
        e > 0 && tile_of(joins[e - 1].i) == tile_of(join.i) && tile_of(joins[e - 1].j) == tile_of(join.j);
    if (known) continue;
    ++graph.tile_first_pair[tile_of(join.i) + 1];
    first.push_back(static_cast<std::int64_t>(e));
  }
  first.push_back(static_cast<std::int64_t>(joins.size()));
  for (std::size_t t = 0; t < tiles; ++t) first[t + 1] += first[t];
  first.erase(first.begin() + static_cast<std::ptrdiff_t>(tiles));  // where the pairs begin
  graph.tile_first_pair[0] = static_cast<std::int32_t>(tiles);
  for (std::size_t t = 0; t < tiles; ++t) graph.tile_first_pair[t + 1] += graph.tile_first_pair[t];
  graph.first.resize(joins.size());
  graph.second.resize(joins.size());
  graph.bonded.resize(joins.size());
  for (std::size_t e = 0; e < joins.size(); ++e) {
    auto at = e;
    if (!across(joins[e])) {
      const auto begin = first[tile_of(joins[e].i)], end = first[tile_of(joins[e].i) + 1];
      at = static_cast<std::size_t>(begin + edge_at(static_cast<std::int64_t>(e) - begin, end - begin));
    }
    graph.first[at] = joins[e].i;
    graph.second[at] = joins[e].j;
    graph.bonded[at] = joins[e].bonded ? 1 : 0;
  }
}

}  // namespace

ContactGraph build_contact_graph(const Array<double>& x, const Array<double>& y, const Array<double>& radius,
                                 const std::vector<Hole>& holes, double gap_tolerance,
                                 std::span<const std::int64_t> bonds, const Grading& sizes) {
  ContactGraph graph;
  const std::size_t n = x.size();
  graph.sizes = sizes;
  graph.mean_radius = sizes.graded()
                          ? sizes.fine
                          : std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(n);

  Array<double> cx, cy, cr;
  std::vector<std::int32_t> left(n, -1);  // number of each disc once the wells are cut
  for (auto* values : {&cx, &cy, &cr}) values->reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 centre{x[i], y[i]};
    const bool inside = std::any_of(holes.begin(), holes.end(), [&](const Hole& hole) {
      const Vec2 d = centre - hole.centre;
      return dot(d, d) < hole.radius * hole.radius;
    });
    if (inside) {
      ++graph.removed_in_wells;
      continue;
    }
    left[i] = static_cast<std::int32_t>(cx.size());
    cx.push_back(x[i]);
    cy.push_back(y[i]);
    cr.push_back(radius[i]);
  }
  if (cx.size() < 4)
    throw Error(ErrorKind::model,
                "fewer than 4 discs are left after cutting the wells; use more discs or smaller wells");

  auto joins = near_pairs(cx, cy, cr, graph.mean_radius, sizes, gap_tolerance);
  if (!bonds.empty()) apply_bonds(cx, cy, cr, bonds, left, joins);
  graph.removed_crossings = remove_crossings(cx, cy, *std::max_element(cr.begin(), cr.end()), joins);
  const auto held = discs_held(cx.size(), joins);

  std::vector<std::int32_t> number(cx.size(), -1);
  const auto count = static_cast<std::size_t>(std::count(held.begin(), held.end(), 1));
  for (auto* values : {&graph.x, &graph.y, &graph.radius}) values->reserve(count);
  for (std::size_t i = 0; i < cx.size(); ++i) {
    if (!held[i]) continue;
    number[i] = static_cast<std::int32_t>(graph.x.size());
    graph.x.push_back(cx[i]);
    graph.y.push_back(cy[i]);
    graph.radius.push_back(cr[i]);
  }
  graph.removed_floaters = static_cast<std::int64_t>(cx.size() - graph.x.size());
  std::size_t kept = 0;
  for (const auto& join : joins) {
    if (held[join.i] && held[join.j]) joins[kept++] = {number[join.i], number[join.j], join.gap, join.bonded};
  }
  joins.resize(kept);
  number_edges(joins, graph);
  if (graph.x.size() < 4) {
    throw Error(ErrorKind::model,
                "no coherent rock is left: fewer than 4 discs have two bonds; raise bond.gap_tolerance or "
                "lower packing.porosity");
  }
  return graph;
}

}  // namespace hfrac
