// SPDX-License-Identifier: BSD-3-Clause
#include "heat/expansion.hpp"

namespace hfrac {

void feel_temperature(Assembly& a, const Array<double>& temperature, const MicroTable& table,
                      const Options& o) {
  auto& t = a.thermal;
  const auto discs = static_cast<std::size_t>(a.disc_count());
  for (auto* values : {&t.growth, &t.stiffness_share, &t.strength_share, &t.friction_share})
    values->resize(discs);
  const double alpha = o.thermal_expansion, start = o.thermal_rock_temperature;
  for (std::size_t i = 0; i < discs; ++i) {
    const MicroShares shares = table.at(temperature[i]);
    t.growth[i] = alpha * a.radius[i] * (temperature[i] - start);
    t.stiffness_share[i] = shares.stiffness;
    t.strength_share[i] = shares.strength;
    t.friction_share[i] = shares.friction;
  }
  combine_shares(a, o);
}

}  // namespace hfrac
