// SPDX-License-Identifier: BSD-3-Clause
#include "frac/holed_plate.hpp"

#include <algorithm>

namespace hfrac {

HoledPlate::Stress HoledPlate::at(Vec2 place) const {
  Stress s{far_xx, far_yy, 0.0};
  const double sum = 0.5 * (far_xx + far_yy), difference = 0.5 * (far_xx - far_yy);
  for (const auto& hole : holes) {
    const Vec2 d = place - hole.centre;
    const double r2 = std::max(dot(d, d), hole.radius * hole.radius), k = hole.radius * hole.radius / r2;
    const double c2 = (d.x * d.x - d.y * d.y) / r2, s2 = 2.0 * d.x * d.y / r2;  // of twice the angle
    const double even = (hole.pressure - sum) * k;
    // Changes of the radial, hoop and shear stress.
    const double radial = even + difference * (3.0 * k * k - 4.0 * k) * c2;
    const double hoop = -even - difference * 3.0 * k * k * c2;
    const double shear = -difference * (2.0 * k - 3.0 * k * k) * s2;
    const double mean = 0.5 * (radial + hoop), half = 0.5 * (radial - hoop);
    s.xx += mean + half * c2 - shear * s2;
    s.yy += mean - half * c2 + shear * s2;
    s.xy += half * s2 + shear * c2;
  }
  return s;
}

}  // namespace hfrac
