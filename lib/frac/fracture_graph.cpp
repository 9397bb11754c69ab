// SPDX-License-Identifier: BSD-3-Clause
#include "frac/fracture_graph.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <set>

#include "model/joint_pores.hpp"

namespace hfrac {
namespace {

std::int32_t farthest(const FractureGraph::Ways& ways) {
  return std::max_element(ways.begin(), ways.end(),
                          [](const auto& a, const auto& b) { return a.second.length < b.second.length; })
      ->first;
}

}  // namespace

double FractureGraph::leg(const Network& n, std::int32_t domain, std::int64_t bond, Vec2 middle) {
  if (const double piece = joint_length(n, static_cast<std::size_t>(bond)); piece > 0.0) return 0.5 * piece;
  if (n.kind[domain] != DomainKind::rock) return 0.0;
  const Vec2 way = n.centroid[domain] - middle;
  return norm(way);
}

void FractureGraph::add(const Network& n, std::int64_t bond, Vec2 middle) {
  const auto l = n.left[bond], r = n.right[bond];
  const double way = leg(n, l, bond, middle) + leg(n, r, bond, middle);
  if (edges_.empty()) first_ = l;
  edges_[l].push_back({r, bond, way});
  edges_[r].push_back({l, bond, way});
}

FractureGraph::Ways FractureGraph::shortest_from(std::int32_t start) const {  // Dijkstra 1959
  Ways ways;
  using Item = std::pair<double, std::int32_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  ways[start].length = 0.0;
  open.emplace(0.0, start);
  while (!open.empty()) {
    const auto [length, at] = open.top();
    open.pop();
    if (length > ways[at].length) continue;
    for (const Edge& edge : edges_.at(at)) {
      Way& next = ways[edge.to];
      const bool nearer = next.length < 0.0 || length + edge.length < next.length;
      if (!nearer) continue;  // nor where a length is no number: the search ends for any input
      next = {length + edge.length, at, edge.bond};
      open.emplace(next.length, edge.to);
    }
  }
  return ways;
}

std::vector<std::int32_t> FractureGraph::wings(const Ways& ways, std::int32_t start) const {
  std::vector<std::int32_t> ends;
  std::set<std::int32_t> seen{start};
  for (const Edge& begin : edges_.at(start)) {
    if (!seen.insert(begin.to).second) continue;
    std::int32_t end = begin.to;
    std::vector<std::int32_t> stack{begin.to};
    while (!stack.empty()) {
      const auto at = stack.back();
      stack.pop_back();
      if (ways.at(at).length > ways.at(end).length) end = at;
      for (const Edge& edge : edges_.at(at))
        if (seen.insert(edge.to).second) stack.push_back(edge.to);
    }
    ends.push_back(end);
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [&](auto a, auto b) { return ways.at(a).length > ways.at(b).length; });
  return ends;
}

std::pair<std::int32_t, std::int32_t> FractureGraph::ends() const {
  const auto one = farthest(shortest_from(first_));
  return {one, farthest(shortest_from(one))};
}

std::vector<std::int64_t> FractureGraph::bonds_to(const Ways& ways, std::int32_t domain) {
  std::vector<std::int64_t> bonds;
  for (auto at = domain; ways.at(at).bond >= 0; at = ways.at(at).from) bonds.push_back(ways.at(at).bond);
  std::reverse(bonds.begin(), bonds.end());
  return bonds;
}

}  // namespace hfrac
