// SPDX-License-Identifier: BSD-3-Clause
#include "frac/linking.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace hfrac {
namespace {

using Members = std::vector<std::size_t>;

// Which sources belong together; the smallest number of a set stands for it.
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

double linking_distance(std::span<const Source> sources, const LinkRule& rule) {
  if (rule.distance > 0.0 || sources.empty()) return rule.distance;
  double sum = 0.0;
  for (const auto& source : sources) sum += source.disc_distance;
  return 2.0 * sum / static_cast<double>(sources.size());
}

bool linked(const Source& p, const Source& q, double distance, const LinkRule& rule) {
  const Vec2 between = p.position - q.position;
  return dot(between, between) <= distance * distance && std::abs(p.time - q.time) <= rule.time_window &&
         (rule.cycle_window == 0 || std::abs(p.cycle - q.cycle) <= rule.cycle_window);
}

// Cells as wide as the linking distance: who may be linked to a source lies in its own or a neighbouring one.
Links link(std::span<const Source> sources, const LinkRule& rule) {
  const double distance = linking_distance(sources, rule);
  Links links(sources.size());
  std::map<std::pair<double, double>, Members> cells;  // ordered: results do not depend on hashing
  for (std::size_t c = 0; c < sources.size(); ++c) {
    const Vec2 at = sources[c].position;
    const double column = distance > 0.0 ? std::floor(at.x / distance) : at.x;
    const double row = distance > 0.0 ? std::floor(at.y / distance) : at.y;
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        const auto cell = cells.find({column + i, row + j});
        if (cell == cells.end()) continue;
        for (const auto other : cell->second) {
          if (linked(sources[other], sources[c], distance, rule)) links.join(other, c);
        }
      }
    }
    cells[{column, row}].push_back(c);
  }
  return links;
}

}  // namespace

std::vector<Members> linked_sources(std::span<const Source> sources, const LinkRule& rule) {
  Links links = link(sources, rule);
  std::map<std::size_t, Members> groups;  // by first source
  for (std::size_t c = 0; c < sources.size(); ++c) groups[links.root(c)].push_back(c);
  std::vector<Members> events;
  events.reserve(groups.size());
  for (auto& [first, members] : groups) events.push_back(std::move(members));
  return events;
}

}  // namespace hfrac
