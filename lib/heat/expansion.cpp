// SPDX-License-Identifier: BSD-3-Clause
#include "heat/expansion.hpp"

namespace hfrac {

void feel_temperature(Assembly& a, const Array<double>& temperature, const MicroTable& table,
                      const Options& o) {
  auto& t = a.thermal;
  const auto discs = static_cast<std::size_t>(a.disc_count()), bonds = a.first.size();
  for (auto* values : {&t.growth, &t.stiffness_share, &t.friction_share}) values->resize(discs);
  for (auto* values : {&t.gap, &t.bond_stiffness, &t.bond_strength, &t.bond_friction}) values->resize(bonds);
  const double alpha = o.thermal_expansion, start = o.thermal_rock_temperature;
  for (std::size_t i = 0; i < discs; ++i) {
    const MicroShares shares = table.at(temperature[i]);
    t.growth[i] = alpha * a.radius[i] * (temperature[i] - start);
    t.stiffness_share[i] = shares.stiffness;
    t.friction_share[i] = shares.friction;
  }
  for (std::size_t e = 0; e < bonds; ++e) {
    const auto i = static_cast<std::size_t>(a.first[e]), j = static_cast<std::size_t>(a.second[e]);
    const double arm_j = a.length[e] - a.arm[e];
    t.gap[e] = alpha * (a.arm[e] * (temperature[i] - start) + arm_j * (temperature[j] - start));
    t.bond_stiffness[e] = 0.5 * (t.stiffness_share[i] + t.stiffness_share[j]);
    t.bond_friction[e] = 0.5 * (t.friction_share[i] + t.friction_share[j]);
    t.bond_strength[e] = 0.5 * (table.at(temperature[i]).strength + table.at(temperature[j]).strength);
  }
  combine_shares(a, o);
}

}  // namespace hfrac
