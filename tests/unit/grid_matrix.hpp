// SPDX-License-Identifier: BSD-3-Clause
// A matrix for the tests of sparse factors.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "linear/front_tree.hpp"

namespace grid_matrix {

// Three unknowns a node on a grid, unsymmetric, with a diagonal that asks for exchanges.
struct GridMatrix {
  std::vector<hfrac::Vec2> position;
  hfrac::Adjacency graph;
  std::vector<std::int32_t> node_start{0};
  std::vector<hfrac::MatrixPlace> places;
  std::vector<double> values, right;
  explicit GridMatrix(std::int32_t side);
  [[nodiscard]] hfrac::FrontTree::EachPlace each_place() const {
    return [this](const auto& visit) {
      for (const auto& place : places) visit(place);
    };
  }
};

inline GridMatrix::GridMatrix(std::int32_t side) {
  hfrac::Random random(3);
  graph.start.push_back(0);
  for (std::int32_t y = 0; y < side; ++y) {
    for (std::int32_t x = 0; x < side; ++x) {
      const std::int32_t node = y * side + x;
      position.push_back({static_cast<double>(x), static_cast<double>(y)});
      node_start.push_back(3 * (node + 1));
      for (const auto& [dx, dy] :
           {std::pair{0, -1}, std::pair{-1, 0}, std::pair{0, 0}, std::pair{1, 0}, std::pair{0, 1}}) {
        if (x + dx < 0 || x + dx >= side || y + dy < 0 || y + dy >= side) continue;
        const std::int32_t other = (y + dy) * side + x + dx;
        if (other != node) graph.neighbour.push_back(other);
        for (std::int32_t r = 0; r < 3; ++r) {
          for (std::int32_t c = 0; c < 3; ++c) {
            places.push_back({3 * node + r, 3 * other + c});
            const double big = other == node && r == (c + 1) % 3 ? 8.0 : 0.0;  // beside the diagonal
            values.push_back(big + random.uniform() - 0.5);
          }
        }
      }
      graph.start.push_back(static_cast<std::int32_t>(graph.neighbour.size()));
    }
  }
  right.resize(static_cast<std::size_t>(3 * side * side));
  for (auto& value : right) value = random.uniform() - 0.5;
}

}  // namespace grid_matrix
