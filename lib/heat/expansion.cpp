// SPDX-License-Identifier: BSD-3-Clause
#include "heat/expansion.hpp"

namespace hfrac {

void feel_temperature(Assembly& a, const Array<double>& temperature, const MicroTable& table,
                      const Options& o) {
  auto& t = a.thermal;
  const auto discs = static_cast<std::size_t>(a.disc_count());
  for (auto* values : {&t.growth, &t.stiffness_factor, &t.strength_factor, &t.friction_factor})
    values->resize(discs);
  const double alpha = o.thermal_expansion, start = o.thermal_rock_temperature;
  for (std::size_t i = 0; i < discs; ++i) {
    const MicroFactors factors = table.at(temperature[i]);
    t.growth[i] = alpha * a.radius[i] * (temperature[i] - start);
    t.stiffness_factor[i] = factors.stiffness;
    t.strength_factor[i] = factors.strength;
    t.friction_factor[i] = factors.friction;
  }
  combine_factors(a, o);
}

}  // namespace hfrac
