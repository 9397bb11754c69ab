// SPDX-License-Identifier: BSD-3-Clause
// What a pipe of aperture w and length L lets through under a pressure drop: the law of the fluid in a slot.
//
// A shear-thinning fluid has the rate of shear  tau / eta + (tau / K)^(1/n):  a power law where it is sheared fast and a
// viscosity eta at rest, which a power law alone does not have. Fluidities add up, so the slot's flow is the sum of both laws',
//     q = w^3 / (12 eta) G + n / (2 (2 n + 1)) w^2 (w G / (2 K))^(1/n),     G = dp / L,
// the second term growing with w^(2 + 1/n) (Bird, Armstrong and Hassager 1987, table 4.2-1, slot; the sum is their Ellis
// fluid). With fluid.consistency = 0 the first term is all: the cubic law of eq. 6.
#pragma once

#include <cmath>

#include "options/options.hpp"

namespace hfrac {

class FluidLaw {
 public:
  explicit FluidLaw(const Options& o)
      : viscosity_(o.fluid_viscosity), power_(1.0 / o.fluid_power_index), thins_(o.fluid_consistency > 0.0) {
    const double n = o.fluid_power_index;
    if (thins_) factor_ = n / (2.0 * (2.0 * n + 1.0)) * std::pow(2.0 * o.fluid_consistency, -power_);
  }
  [[nodiscard]] bool thins() const { return thins_; }
  [[nodiscard]] double index() const { return 1.0 / power_; }

  // Conductance at rest, w^3 / (12 eta L) [m2/(Pa s)].
  [[nodiscard]] double at_rest(double aperture, double length) const {
    return aperture * aperture * aperture / (12.0 * viscosity_ * length);
  }
  // Coefficient of |dp|^(1/n - 1) in the conductance.
  [[nodiscard]] double thinning(double aperture, double length) const {
    return thins_ ? factor_ * aperture * aperture * std::pow(aperture / length, power_) : 0.0;
  }
  // Flow over pressure drop [m2/(Pa s)], and the flow's change with the drop and with the aperture over it.
  [[nodiscard]] double conductance(double at_rest, double thinning, double drop) const {
    return thins_ ? at_rest + thinning * std::pow(std::abs(drop), power_ - 1.0) : at_rest;
  }
  struct Response {
    double conductance;  // q / dp
    double slope;        // d q / d dp
    double by_aperture;  // d q / d w over q / w
  };
  // With rock of this conductance behind the pipe; 0: none. Of a fluid that does not thin.
  [[nodiscard]] static Response in_series(Response pipe, double beyond) {
    if (beyond <= 0.0) return pipe;
    const double share = beyond / (pipe.conductance + beyond);  // of the drop that is the pipe's
    return {pipe.conductance * share, pipe.slope * share, pipe.by_aperture * share};
  }
  // `share`: viscosity in the pipe over fluid.viscosity; 1 of a fluid that thins.
  [[nodiscard]] Response respond(double aperture, double length, double drop, double share = 1.0) const {
    const double rest = at_rest(aperture, length) / share;
    if (!thins_) return {rest, rest, 3.0};
    const double thin = thinning(aperture, length) * std::pow(std::abs(drop), power_ - 1.0),
                 sum = rest + thin;
    return {sum, rest + power_ * thin, (3.0 * rest + (2.0 + power_) * thin) / sum};
  }

 private:
  double viscosity_, power_;  // Pa s; 1 / n
  bool thins_;
  double factor_ = 0.0;
};

}  // namespace hfrac
