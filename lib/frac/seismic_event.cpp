// SPDX-License-Identifier: BSD-3-Clause
#include "frac/seismic_event.hpp"

#include <cmath>
#include <limits>

namespace hfrac {

// Scalar moment: Silver and Jordan (1982), sqrt(m_ij m_ij / 2). Its magnitude: Hanks and Kanamori (1979), 2/3 log10
// M0 - 10.7 with M0 in dyn cm. Energy magnitude: Choy and Boatwright (1995). Isotropic share: Feignier and Young
// (1992), trace over the sum of trace and deviatoric eigenvalues, here in the plane.
void rate_strength(SeismicEvent& event) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  constexpr double dyne_centimetres = 1e7;  // per N m
  event.moment = std::sqrt(0.5 * (event.xx * event.xx + event.yy * event.yy) + event.xy * event.xy);
  event.magnitude =
      event.moment > 0.0 ? 2.0 / 3.0 * std::log10(dyne_centimetres * event.moment) - 10.7 : nothing;
  event.energy_magnitude = event.energy > 0.0 ? 2.0 / 3.0 * std::log10(event.energy) - 2.9 : nothing;
  const double trace = event.xx + event.yy;
  const double deviator = std::hypot(0.5 * (event.xx - event.yy), event.xy);
  const double all = std::abs(trace) + 2.0 * deviator;
  event.isotropic_fraction = all > 0.0 ? trace / all : 0.0;
}

}  // namespace hfrac
