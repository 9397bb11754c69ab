// SPDX-License-Identifier: BSD-3-Clause
#include "linear/front_tree.hpp"

#include <algorithm>

namespace hfrac {
namespace {

constexpr double worth_sharing = 2e7;  // operations: a factor of less is made by one worker sooner
constexpr double share_of_subtree = 1.0 / 24.0;

std::size_t at(std::int64_t k) {
  return static_cast<std::size_t>(k);
}

// Boundary of every part, as nodes in order of elimination: later neighbours of its own, and its children's boundaries.
std::vector<std::vector<std::int32_t>> boundaries(const Dissection& cuts, const Adjacency& graph,
                                                  const std::vector<std::int32_t>& turn) {
  std::vector<std::vector<std::int32_t>> boundary(cuts.parts.size());
  const auto earlier = [&](std::int32_t a, std::int32_t b) { return turn[at(a)] < turn[at(b)]; };
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    auto& list = boundary[f];
    const auto& part = cuts.parts[f];
    for (auto k = part.first; k < part.last; ++k) {
      const auto node = at(cuts.order[at(k)]);
      for (auto q = graph.start[node]; q < graph.start[node + 1]; ++q) {
        const auto other = graph.neighbour[at(q)];
        if (turn[at(other)] >= part.last) list.push_back(other);
      }
    }
    std::sort(list.begin(), list.end(), earlier);
    list.erase(std::unique(list.begin(), list.end()), list.end());
    if (part.parent < 0) continue;
    auto& above = boundary[at(part.parent)];
    const auto& parent = cuts.parts[at(part.parent)];
    for (const auto node : list) {
      if (turn[at(node)] >= parent.last) above.push_back(node);
    }
  }
  return boundary;
}

}  // namespace

void FrontTree::analyse(const std::vector<std::int32_t>& node_start, const std::vector<Vec2>& position,
                        const Adjacency& graph, const std::vector<char>& late,
                        const std::vector<MatrixPlace>& places) {
  std::vector<std::int32_t> weight;
  for (std::size_t k = 0; k < position.size(); ++k) weight.push_back(node_start[k + 1] - node_start[k]);
  const Dissection cuts = dissect(position, graph, weight, late);
  const auto nodes = position.size(), parts = cuts.parts.size();
  std::vector<std::int32_t> turn(nodes), part_of(nodes);
  for (std::size_t k = 0; k < nodes; ++k) turn[at(cuts.order[k])] = static_cast<std::int32_t>(k);
  for (std::size_t f = 0; f < parts; ++f) {
    for (auto k = cuts.parts[f].first; k < cuts.parts[f].last; ++k)
      part_of[at(cuts.order[at(k)])] = static_cast<std::int32_t>(f);
  }
  const auto boundary = boundaries(cuts, graph, turn);

  *this = {};
  unknown_count = node_start.back();
  fronts.resize(parts);
  std::vector<double> work(parts, 0.0);
  const auto add_node = [&](std::int32_t node) {
    for (auto u = node_start[at(node)]; u < node_start[at(node) + 1]; ++u) unknowns.push_back(u);
  };
  for (std::size_t f = 0; f < parts; ++f) {
    Front& front = fronts[f];
    front.unknowns = static_cast<std::int64_t>(unknowns.size());
    for (auto k = cuts.parts[f].first; k < cuts.parts[f].last; ++k) add_node(cuts.order[at(k)]);
    front.pivots = static_cast<std::int32_t>(static_cast<std::int64_t>(unknowns.size()) - front.unknowns);
    for (const auto node : boundary[f]) add_node(node);
    front.size = static_cast<std::int32_t>(static_cast<std::int64_t>(unknowns.size()) - front.unknowns);
    front.parent = cuts.parts[f].parent;
    front.columns = columns;
    front.rows = rows;
    front.swaps = swaps;
    front.carried = carried;
    const std::int64_t m = front.size, p = front.pivots, b = m - p;
    columns += m * p;
    rows += p * b;
    swaps += p;
    carried += b + dense_slack;
    largest = std::max(largest, m);
    for (std::int64_t k = 0; k < p; ++k) work[f] += 2.0 * static_cast<double>((m - k) * (m - k));
    operations += work[f];
    if (front.parent < 0) continue;
    auto* child = fronts[at(front.parent)].child;
    child[child[0] < 0 ? 0 : 1] = static_cast<std::int32_t>(f);
  }
  std::vector<std::int32_t> local(at(unknown_count), -1);
  for (auto& front : fronts) {
    front.into_parent = static_cast<std::int64_t>(into_parent.size());
    if (front.parent < 0) continue;
    const Front& parent = fronts[at(front.parent)];
    for (std::int32_t k = 0; k < parent.size; ++k) local[at(unknowns[at(parent.unknowns + k)])] = k;
    for (std::int32_t k = front.pivots; k < front.size; ++k)
      into_parent.push_back(local[at(unknowns[at(front.unknowns + k)])]);
  }
  std::vector<std::int32_t> front_of(at(unknown_count)), turn_of(front_of.size());
  for (std::size_t node = 0; node < nodes; ++node) {
    for (auto u = node_start[node]; u < node_start[node + 1]; ++u) {
      front_of[at(u)] = part_of[node];
      turn_of[at(u)] = turn[node];
    }
  }
  share_entries(places, front_of, turn_of);
  cut(work);
  place_leftovers();
}

// Every entry belongs to the front that eliminates the earlier of its two unknowns.
void FrontTree::share_entries(const std::vector<MatrixPlace>& places,
                              const std::vector<std::int32_t>& front_of,
                              const std::vector<std::int32_t>& turn_of) {
  std::vector<std::int64_t> count(fronts.size() + 1, 0);
  const auto owner = [&](const MatrixPlace& place) {
    const auto r = at(place.row), c = at(place.column);
    return at(turn_of[r] < turn_of[c] ? front_of[r] : front_of[c]);
  };
  for (const auto& place : places) ++count[owner(place) + 1];
  for (std::size_t f = 0; f < fronts.size(); ++f) count[f + 1] += count[f];
  entry.resize(places.size());
  entry_row.resize(places.size());
  entry_column.resize(places.size());
  auto cursor = count;
  for (std::size_t k = 0; k < places.size(); ++k)
    entry[at(cursor[owner(places[k])]++)] = static_cast<std::int32_t>(k);
  std::vector<std::int32_t> local(at(unknown_count), -1);
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    Front& front = fronts[f];
    front.first_entry = count[f];
    front.last_entry = count[f + 1];
    for (std::int32_t k = 0; k < front.size; ++k) local[at(unknowns[at(front.unknowns + k)])] = k;
    for (auto k = front.first_entry; k < front.last_entry; ++k) {
      const auto& place = places[at(entry[at(k)])];
      entry_row[at(k)] = local[at(place.row)];
      entry_column[at(k)] = local[at(place.column)];
    }
  }
}

void FrontTree::cut(const std::vector<double>& work) {
  const auto count = static_cast<std::int32_t>(fronts.size());
  std::vector<double> below = work;  // with all that is beneath
  std::vector<std::int32_t> first(fronts.size());
  for (std::int32_t f = 0; f < count; ++f) {
    first[at(f)] = f;
    for (const auto child : fronts[at(f)].child) {
      if (child < 0) continue;
      below[at(f)] += below[at(child)];
      first[at(f)] = std::min(first[at(f)], first[at(child)]);
    }
  }
  const double most = operations < worth_sharing ? operations : share_of_subtree * operations;
  for (std::int32_t f = 0; f < count; ++f) {
    const auto parent = fronts[at(f)].parent;
    if (below[at(f)] > most)
      top.push_back(f);
    else if (parent < 0 || below[at(parent)] > most)
      subtrees.push_back({first[at(f)], f + 1});
  }
  std::stable_sort(subtrees.begin(), subtrees.end(), [&](const Subtree& a, const Subtree& b) {
    return below[at(a.last - 1)] > below[at(b.last - 1)];
  });
}

// Within a subtree what fronts leave over is stacked, and a front's children are the last ones on the stack.
void FrontTree::place_leftovers() {
  const auto keep = [this](Front& front) {
    const std::int64_t b = front.size - front.pivots;
    front.kept = true;
    front.leftover = kept;
    kept += b * b;
  };
  for (const auto f : top) keep(fronts[at(f)]);
  for (const auto& subtree : subtrees) {
    std::int64_t height = 0;
    for (auto f = subtree.first; f < subtree.last; ++f) {
      Front& front = fronts[at(f)];
      const std::int64_t b = front.size - front.pivots;
      largest_below = std::max<std::int64_t>(largest_below, front.size);
      if (f + 1 == subtree.last) {
        keep(front);
        continue;
      }
      for (const auto child : front.child) {
        if (child < 0) continue;
        const std::int64_t n = fronts[at(child)].size - fronts[at(child)].pivots;
        height -= n * n;
      }
      front.leftover = height;
      height += b * b;
      stacked = std::max(stacked, height);
    }
  }
}

}  // namespace hfrac
