// SPDX-License-Identifier: BSD-3-Clause
#include "rock/rock_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

// A block of na by nb elements that closes upon itself; node (a, b) with 0 <= a <= 2 na, b modulo 2 nb.
struct Block {
  int na, nb;

  [[nodiscard]] std::int32_t at(int a, int b) const { return b % (2 * nb) * (2 * na + 1) + a; }
  [[nodiscard]] std::vector<RockMesh::Element> elements() const {
    std::vector<RockMesh::Element> all;
    for (int j = 0; j < 2 * nb; j += 2) {
      for (int i = 0; i < 2 * na; i += 2) {
        all.push_back({at(i, j), at(i + 2, j), at(i + 2, j + 2), at(i, j + 2), at(i + 1, j), at(i + 2, j + 1),
                       at(i + 1, j + 2), at(i, j + 1), at(i + 1, j + 1)});
      }
    }
    return all;
  }
};

}  // namespace

RockMesh plate_mesh(double width, double height, Vec2 centre, double radius, int around, int outward) {
  const int a_side = std::max(2, (around + 3) / 4);
  const Block block{outward, 4 * a_side};
  const int na = 2 * outward, nb = 2 * block.nb, b_side = 2 * a_side;
  const std::array<Vec2, 5> corner = {
      {{width, 0.0}, {width, height}, {0.0, height}, {0.0, 0.0}, {width, 0.0}}};
  constexpr std::array<RockSide, 4> side = {RockSide::right, RockSide::top, RockSide::left, RockSide::bottom};
  // Distances from the wall grow like those from the centre: elements keep their shape.
  const double growth = 0.5 * std::min(width, height) / radius;
  RockMesh mesh;
  for (int b = 0; b < nb; ++b) {
    const auto s = static_cast<std::size_t>(b / b_side);
    const Vec2 rim = corner[s] + (static_cast<double>(b % b_side) / b_side) * (corner[s + 1] - corner[s]);
    const Vec2 ray = rim - centre;
    const Vec2 wall = centre + (radius / std::hypot(ray.x, ray.y)) * ray;
    for (int a = 0; a <= na; ++a) {
      const double share = (std::pow(growth, static_cast<double>(a) / na) - 1.0) / (growth - 1.0);
      mesh.node.push_back(wall + share * (rim - wall));
    }
  }
  mesh.element = block.elements();
  for (int b = 0; b < nb; b += 2) {
    mesh.edge.push_back({side[static_cast<std::size_t>(b / b_side)], block.at(na, b), block.at(na, b + 1),
                         block.at(na, b + 2)});
    mesh.edge.push_back({RockSide::well, block.at(0, b + 2), block.at(0, b + 1), block.at(0, b)});
  }
  return mesh;
}

}  // namespace hfrac
