// SPDX-License-Identifier: BSD-3-Clause
#include "linear/dissection.hpp"

#include <algorithm>

#include "linear/separator.hpp"

namespace hfrac {
namespace {

constexpr std::ptrdiff_t small_enough = 8;  // nodes of a part that is cut no further

struct Cutter {
  const std::vector<Vec2>& position;
  const Adjacency& graph;
  const std::vector<std::int32_t>& weight;
  std::vector<std::int32_t> side;   // the half a node is in now
  std::vector<std::int32_t> local;  // number among those of its half that touch the other, or -1
  std::int32_t halves = 0;
  Dissection result;

  void close(const std::int32_t* begin, const std::int32_t* end, std::int32_t left, std::int32_t right) {
    const auto first = static_cast<std::int32_t>(result.order.size());
    result.order.insert(result.order.end(), begin, end);
    const auto here = static_cast<std::int32_t>(result.parts.size());
    result.parts.push_back({first, static_cast<std::int32_t>(result.order.size()), -1});
    for (const auto child : {left, right}) {
      if (child >= 0) result.parts[static_cast<std::size_t>(child)].parent = here;
    }
  }

  // Number of the part made of these nodes.
  std::int32_t cut(std::int32_t* begin, std::int32_t* end) {
    if (end - begin <= small_enough) {
      close(begin, end, -1, -1);
      return static_cast<std::int32_t>(result.parts.size()) - 1;
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
    const std::int32_t left = ++halves, right = ++halves;
    for (auto* node = begin; node != middle; ++node) side[static_cast<std::size_t>(*node)] = left;
    for (auto* node = middle; node != end; ++node) side[static_cast<std::size_t>(*node)] = right;
    const auto separator = separate(begin, middle, right);
    const auto kept = [&](std::int32_t node) { return side[static_cast<std::size_t>(node)] != 0; };
    auto* first_end = std::stable_partition(begin, middle, kept);
    auto* second_end = std::stable_partition(middle, end, kept);
    const auto first = begin == first_end ? -1 : cut(begin, first_end);
    const auto second = middle == second_end ? -1 : cut(middle, second_end);
    close(separator.data(), separator.data() + separator.size(), first, second);
    return static_cast<std::int32_t>(result.parts.size()) - 1;
  }

  // Nodes without which the two halves do not touch, ascending; their side becomes 0.
  std::vector<std::int32_t> separate(const std::int32_t* begin, const std::int32_t* middle,
                                     std::int32_t right) {
    std::vector<std::int32_t> left_nodes, right_nodes, left_weight, right_weight;
    std::vector<Crossing> crossings;
    for (const auto* node = begin; node != middle; ++node) {
      bool touches = false;
      for (auto k = graph.start[static_cast<std::size_t>(*node)];
           k < graph.start[static_cast<std::size_t>(*node) + 1]; ++k) {
        const auto other = graph.neighbour[static_cast<std::size_t>(k)];
        if (side[static_cast<std::size_t>(other)] != right) continue;
        auto& number = local[static_cast<std::size_t>(other)];
        if (number < 0) {
          number = static_cast<std::int32_t>(right_nodes.size());
          right_nodes.push_back(other);
          right_weight.push_back(weight[static_cast<std::size_t>(other)]);
        }
        crossings.push_back({static_cast<std::int32_t>(left_nodes.size()), number});
        touches = true;
      }
      if (!touches) continue;
      left_nodes.push_back(*node);
      left_weight.push_back(weight[static_cast<std::size_t>(*node)]);
    }
    std::vector<char> left_in, right_in;
    lightest_cover(left_weight, right_weight, crossings, left_in, right_in);
    std::vector<std::int32_t> separator;
    for (std::size_t k = 0; k < left_nodes.size(); ++k) {
      if (left_in[k] != 0) separator.push_back(left_nodes[k]);
    }
    for (std::size_t k = 0; k < right_nodes.size(); ++k) {
      local[static_cast<std::size_t>(right_nodes[k])] = -1;
      if (right_in[k] != 0) separator.push_back(right_nodes[k]);
    }
    std::sort(separator.begin(), separator.end());
    for (const auto node : separator) side[static_cast<std::size_t>(node)] = 0;
    return separator;
  }
};

}  // namespace

Dissection dissect(const std::vector<Vec2>& position, const Adjacency& graph,
                   const std::vector<std::int32_t>& weight, const std::vector<char>& late) {
  std::vector<std::int32_t> nodes, end;
  for (std::size_t k = 0; k < position.size(); ++k)
    (late[k] != 0 ? end : nodes).push_back(static_cast<std::int32_t>(k));
  Cutter cutter{position,
                graph,
                weight,
                std::vector<std::int32_t>(position.size(), 0),
                std::vector<std::int32_t>(position.size(), -1),
                0,
                {}};
  cutter.result.order.reserve(position.size());
  const auto top = nodes.empty() ? -1 : cutter.cut(nodes.data(), nodes.data() + nodes.size());
  if (!end.empty()) cutter.close(end.data(), end.data() + end.size(), top, -1);
  return std::move(cutter.result);
}

}  // namespace hfrac
