// SPDX-License-Identifier: BSD-3-Clause
#include "model/wellbore.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hfrac {
namespace {

constexpr double laminar_rate = 1e-8;  // m2/s

}  // namespace

WellFriction well_friction(double density, double count, double diameter, double discharge, double near_well,
                           double height) {
  WellFriction friction;
  const double length = height > 0.0 ? height : 1.0, coefficient = discharge > 0.0 ? discharge : 0.6;
  if (count > 0.0) {
    const double area = 0.25 * std::numbers::pi * diameter * diameter,
                 speed = length / (count * coefficient * area);
    friction.square = 0.5 * density * speed * speed;  // rho / 2 (Q / (n C_d A))^2
  }
  friction.root = near_well * std::sqrt(length);
  return friction;
}

double WellFriction::drop(double rate) const {
  const double q = std::abs(rate);
  return std::copysign(square * q * (q + laminar_rate) + root * std::sqrt(q), rate);
}

// With s = sqrt(q): square (s^4 + laminar s^2) + root s = drop, which rises and is convex; Newton's method falls on its root from above.
WellFriction::Response WellFriction::respond(double drop) const {
  const double wanted = std::abs(drop);
  double s = std::numeric_limits<double>::infinity();
  if (square > 0.0) s = std::min(s, std::sqrt(std::sqrt(wanted / square)));
  if (root > 0.0) s = std::min(s, wanted / root);
  double slope = 0.0;  // of the drop with s
  for (int k = 0; k < 60; ++k) {
    const double q = s * s, off = square * q * (q + laminar_rate) + root * s - wanted;
    slope = square * s * (4.0 * q + 2.0 * laminar_rate) + root;
    const double next = slope > 0.0 ? std::max(0.0, s - off / slope) : 0.0;
    if (!(next < s)) break;
    s = next;
  }
  const double by_rate = 2.0 * s > 0.0 ? slope / (2.0 * s) : square * laminar_rate;
  return {std::copysign(s * s, drop), root > 0.0 && s == 0.0 ? 0.0 : 1.0 / by_rate};
}

}  // namespace hfrac
