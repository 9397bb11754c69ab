// SPDX-License-Identifier: BSD-3-Clause
// Shape functions on the square -1..1 by -1..1: nine biquadratic ones for displacements and geometry, four bilinear ones for
// the pressure. Together they are the element of Taylor and Hood (1973), whose pressures stay smooth even when rock and fluid
// cannot be compressed.
#pragma once

#include <array>
#include <cstddef>

#include "core/array.hpp"
#include "rock/rock_mesh.hpp"

namespace hfrac {

// In the order of RockMesh::Element.
constexpr std::array<Vec2, 9> reference_node = {{{-1.0, -1.0},
                                                 {1.0, -1.0},
                                                 {1.0, 1.0},
                                                 {-1.0, 1.0},
                                                 {0.0, -1.0},
                                                 {1.0, 0.0},
                                                 {0.0, 1.0},
                                                 {-1.0, 0.0},
                                                 {0.0, 0.0}}};

// The parabola that is 1 at `node` (-1, 0 or 1) and 0 at the other two; and its slope.
constexpr double parabola(double node, double s) {
  return node == 0.0 ? 1.0 - s * s : 0.5 * s * (s + node);
}
constexpr double parabola_slope(double node, double s) {
  return node == 0.0 ? -2.0 * s : s + 0.5 * node;
}

// All at one point of one element.
struct ElementPoint {
  std::array<double, 9> value;     // of the biquadratic functions
  std::array<Vec2, 9> gradient;    // [1/m]
  std::array<double, 4> pressure;  // of the bilinear functions
  std::array<Vec2, 4> pressure_gradient;
  double jacobian;  // true area per reference area [m2]
  Vec2 place;       // [m]
};

inline ElementPoint at_point(const RockMesh& mesh, const RockMesh::Element& element, double s, double t) {
  ElementPoint p{};
  std::array<Vec2, 9> slope{};
  Vec2 along_s{}, along_t{};
  for (std::size_t k = 0; k < 9; ++k) {
    const Vec2 node = reference_node[k], x = mesh.node[static_cast<std::size_t>(element[k])];
    p.value[k] = parabola(node.x, s) * parabola(node.y, t);
    slope[k] = {parabola_slope(node.x, s) * parabola(node.y, t),
                parabola(node.x, s) * parabola_slope(node.y, t)};
    p.place = p.place + p.value[k] * x;
    along_s = along_s + slope[k].x * x;
    along_t = along_t + slope[k].y * x;
  }
  p.jacobian = cross(along_s, along_t);
  const auto physical = [&](Vec2 g) {
    return Vec2{(along_t.y * g.x - along_s.y * g.y) / p.jacobian,
                (along_s.x * g.y - along_t.x * g.x) / p.jacobian};
  };
  for (std::size_t k = 0; k < 9; ++k) p.gradient[k] = physical(slope[k]);
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 node = reference_node[k];
    p.pressure[k] = 0.25 * (1.0 + node.x * s) * (1.0 + node.y * t);
    p.pressure_gradient[k] =
        physical({0.25 * node.x * (1.0 + node.y * t), 0.25 * node.y * (1.0 + node.x * s)});
  }
  return p;
}

// Gauss's three-point rule: exact to the fifth power.
constexpr std::array<double, 3> gauss_place = {-0.7745966692414834, 0.0, 0.7745966692414834};
constexpr std::array<double, 3> gauss_weight = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

}  // namespace hfrac
