// SPDX-License-Identifier: BSD-3-Clause
// A rectangle of the continuum's elements, which V6 and V7 compare with.
#pragma once

#include <cstdint>
#include <vector>

#include "rock/rock_mesh.hpp"

namespace verification {

// x and y: positions of the element borders, ascending, two at least [m].
inline hfrac::RockMesh rectangle_mesh(const std::vector<double>& x, const std::vector<double>& y) {
  const int na = 2 * (static_cast<int>(x.size()) - 1), nb = 2 * (static_cast<int>(y.size()) - 1);
  const auto at = [na](int a, int b) { return static_cast<std::int32_t>(b * (na + 1) + a); };
  const auto along = [](const std::vector<double>& border, int node) {
    const auto k = static_cast<std::size_t>(node / 2);
    return node % 2 == 0 ? border[k] : 0.5 * (border[k] + border[k + 1]);
  };
  hfrac::RockMesh mesh;
  for (int b = 0; b <= nb; ++b) {
    for (int a = 0; a <= na; ++a) mesh.node.push_back({along(x, a), along(y, b)});
  }
  for (int b = 0; b < nb; b += 2) {
    for (int a = 0; a < na; a += 2) {
      mesh.element.push_back({at(a, b), at(a + 2, b), at(a + 2, b + 2), at(a, b + 2), at(a + 1, b),
                              at(a + 2, b + 1), at(a + 1, b + 2), at(a, b + 1), at(a + 1, b + 1)});
    }
  }
  using enum hfrac::RockSide;
  for (int a = 0; a < na; a += 2) {
    mesh.edge.push_back({bottom, at(a, 0), at(a + 1, 0), at(a + 2, 0)});
    mesh.edge.push_back({top, at(a + 2, nb), at(a + 1, nb), at(a, nb)});
  }
  for (int b = 0; b < nb; b += 2) {
    mesh.edge.push_back({right, at(na, b), at(na, b + 1), at(na, b + 2)});
    mesh.edge.push_back({left, at(0, b + 2), at(0, b + 1), at(0, b)});
  }
  return mesh;
}

}  // namespace verification
