// SPDX-License-Identifier: BSD-3-Clause
#include "solid/infinite_plane.hpp"

#include <Eigen/Cholesky>
#include <array>
#include <numbers>

namespace hfrac {
namespace {

constexpr double far_away = 1000.0;  // times the hole's size, where the plane is at rest
constexpr double ring_share = 0.25;  // of the distance between two points of the rim: thickness of the ring

using Matrix = Eigen::MatrixXd;

struct Point {
  double place, weight;
};
// Gauss points of [-1, 1].
constexpr double root_3_5 = 0.7745966692414834, root_1_3 = 0.5773502691896258;
constexpr std::array<Point, 3> around{{{-root_3_5, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {root_3_5, 5.0 / 9.0}}};
constexpr std::array<Point, 2> outwards{{{-root_1_3, 1.0}, {root_1_3, 1.0}}};

using Element = Eigen::Matrix<double, 12, 12>;

// Quadratic along the rim, linear across the ring: nodes 0 to 2 on the inner side, 3 to 5 on the outer one. False if it is turned over.
bool element_stiffness(const std::array<Vec2, 3>& inner, double ratio, const PlaneElasticity& rock,
                       Element& k) {
  const double nu = rock.poisson, factor = rock.modulus / (1.0 - nu * nu);
  Eigen::Matrix3d law;
  law << factor, factor * nu, 0.0, factor * nu, factor, 0.0, 0.0, 0.0, 0.5 * factor * (1.0 - nu);
  k.setZero();
  for (const auto& along : around) {
    const double s = along.place;
    const std::array<double, 3> shape{0.5 * s * (s - 1.0), 1.0 - s * s, 0.5 * s * (s + 1.0)},
        slope{s - 0.5, -2.0 * s, s + 0.5};
    Vec2 at{}, tangent{};  // on the inner side, from the centre
    for (std::size_t q = 0; q < 3; ++q) {
      at = at + shape[q] * inner[q];
      tangent = tangent + slope[q] * inner[q];
    }
    for (const auto& across : outwards) {
      const double t = 0.5 * (1.0 + across.place), size = 1.0 + (ratio - 1.0) * t;
      const Vec2 by_s = size * tangent, by_t = (ratio - 1.0) * at;
      const double area = cross(by_t, by_s);
      if (!(area > 0.0)) return false;
      Eigen::Matrix<double, 3, 12> strain = Eigen::Matrix<double, 3, 12>::Zero();
      for (Eigen::Index node = 0; node < 6; ++node) {
        const auto q = static_cast<std::size_t>(node % 3);
        const bool outer = node >= 3;
        const double ds = slope[q] * (outer ? t : 1.0 - t), dt = outer ? shape[q] : -shape[q];
        const double dx = (dt * by_s.y - ds * by_t.y) / area, dy = (ds * by_t.x - dt * by_s.x) / area;
        strain(0, 2 * node) = strain(2, 2 * node + 1) = dx;
        strain(1, 2 * node + 1) = strain(2, 2 * node) = dy;
      }
      k += 0.5 * along.weight * across.weight * area * strain.transpose() * law * strain;
    }
  }
  return true;
}

}  // namespace

Matrix infinite_plane_stiffness(const std::vector<Vec2>& rim, Vec2 centre, const PlaneElasticity& rock) {
  const auto points = static_cast<Eigen::Index>(rim.size()), size = 2 * points;
  double ratio = 1.0 + ring_share * 2.0 * std::numbers::pi / static_cast<double>(points);
  Matrix a = Matrix::Zero(size, size), b = a, c = a;
  Element k;
  for (Eigen::Index first = 0; first < points; first += 2) {
    const std::array<Eigen::Index, 3> node{first, first + 1, (first + 2) % points};
    std::array<Vec2, 3> inner;
    for (std::size_t q = 0; q < 3; ++q) inner[q] = rim[static_cast<std::size_t>(node[q])] - centre;
    if (!element_stiffness(inner, ratio, rock, k)) return {};
    for (std::size_t p = 0; p < 3; ++p) {
      for (std::size_t q = 0; q < 3; ++q) {
        const auto row = 2 * static_cast<Eigen::Index>(p), column = 2 * static_cast<Eigen::Index>(q);
        a.block<2, 2>(2 * node[p], 2 * node[q]) += k.block<2, 2>(row, column);
        b.block<2, 2>(2 * node[p], 2 * node[q]) += k.block<2, 2>(row, column + 6);
        c.block<2, 2>(2 * node[p], 2 * node[q]) += k.block<2, 2>(row + 6, column + 6);
      }
    }
  }
  while (ratio < far_away) {
    const Eigen::LLT<Matrix> between(c + a);
    const Matrix from_outside = between.solve(b), from_inside = between.solve(b.transpose());
    a -= b * from_inside;
    c -= b.transpose() * from_outside;
    b = -(b * from_outside).eval();
    ratio *= ratio;
  }
  return 0.5 * (a + a.transpose());
}

}  // namespace hfrac
