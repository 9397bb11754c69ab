// SPDX-License-Identifier: BSD-3-Clause
#include "equilibrium/dissection.hpp"

#include <algorithm>
#include <numeric>

namespace hfrac {
namespace {

constexpr std::ptrdiff_t small_enough = 24;  // nodes of a part that is cut no further

struct Dissection {
  const std::vector<Vec2>& position;
  const Adjacency& graph;
  std::vector<std::int32_t> part;  // number of the part a node is in now
  std::int32_t parts = 0;
  std::vector<std::int32_t> order;

  void cut(std::int32_t* begin, std::int32_t* end) {
    if (end - begin <= small_enough) {
      order.insert(order.end(), begin, end);
      return;
    }
    Vec2 low = position[static_cast<std::size_t>(*begin)], high = low;
    for (const auto* node = begin; node != end; ++node) {
      const Vec2 at = position[static_cast<std::size_t>(*node)];
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    const bool along_x = high.x - low.x >= high.y - low.y;
    const auto before = [&](std::int32_t a, std::int32_t b) {
      const Vec2 p = position[static_cast<std::size_t>(a)], q = position[static_cast<std::size_t>(b)];
      const double pa = along_x ? p.x : p.y, pb = along_x ? q.x : q.y;
      return pa != pb ? pa < pb : a < b;
    };
    auto* middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, before);
    const std::int32_t left = ++parts, right = ++parts;
    for (auto* node = begin; node != middle; ++node) part[static_cast<std::size_t>(*node)] = left;
    for (auto* node = middle; node != end; ++node) part[static_cast<std::size_t>(*node)] = right;
    // Nodes of the right half that touch the left one separate the two.
    auto* rest = std::partition(middle, end, [&](std::int32_t node) {
      for (auto k = graph.start[static_cast<std::size_t>(node)];
           k < graph.start[static_cast<std::size_t>(node) + 1]; ++k) {
        if (part[static_cast<std::size_t>(graph.neighbour[static_cast<std::size_t>(k)])] == left)
          return false;
      }
      return true;
    });
    std::sort(rest, end);  // std::partition keeps no order
    const std::vector<std::int32_t> separator(rest, end);
    for (const auto node : separator) part[static_cast<std::size_t>(node)] = 0;
    cut(begin, middle);
    cut(middle, rest);
    order.insert(order.end(), separator.begin(), separator.end());
  }
};

}  // namespace

std::vector<std::int32_t> dissect(const std::vector<Vec2>& position, const Adjacency& graph,
                                  std::int32_t last) {
  const auto nodes = static_cast<std::int32_t>(position.size()), free = nodes - last;
  std::vector<std::int32_t> all(static_cast<std::size_t>(nodes));
  std::iota(all.begin(), all.end(), 0);
  Dissection d{position, graph, std::vector<std::int32_t>(position.size(), 0), 0, {}};
  d.order.reserve(position.size());
  d.cut(all.data(), all.data() + free);
  d.order.insert(d.order.end(), all.begin() + free, all.end());
  return d.order;
}

}  // namespace hfrac
