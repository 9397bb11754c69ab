// SPDX-License-Identifier: BSD-3-Clause
#include "heat/water_in_pores.hpp"

#include <algorithm>
#include <cmath>

#include "core/water.hpp"
#include "heat/heat_network.hpp"

namespace hfrac {

WaterInPores::WaterInPores(const Assembly& a, Network& n, const Options& o)
    : modulus_at_start_(o.fluid_bulk_modulus) {
  double stiffest = modulus_at_start_;
  const auto kelvins = std::lround(hottest_water - coldest_water);
  for (long k = 0; k <= kelvins; ++k) {
    const double t = std::min(coldest_water + static_cast<double>(k), hottest_water),
                 p = std::clamp(o.fluid_formation_pressure, saturation_pressure(t), highest_water_pressure);
    table_.push_back({o.thermal_fluid_density / water_density(t, p), water_bulk_modulus(t, p)});
    stiffest = std::max(stiffest, table_.back().modulus);
  }
  n.stiffest_water = stiffest / modulus_at_start_;
  n.storing_at_start = n.storing;
  n.growth.assign(n.kind.size(), 0.0);
  sector_.assign(n.corner_disc.size(), 0.0);
  for (std::int64_t d = 1; d < n.domain_count(); ++d) {
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k)
      sector_[k] = sector_angle(a, n, d, k) * a.radius[n.corner_disc[k]];
  }
}

WaterInPores::State WaterInPores::at(double kelvin) const {
  const double place = std::clamp(kelvin, coldest_water, hottest_water) - coldest_water;
  const auto low = std::min(static_cast<std::size_t>(place), table_.size() - 2);
  const double share = place - static_cast<double>(low);
  const State &a = table_[low], &b = table_[low + 1];
  return {a.room + share * (b.room - a.room), a.modulus + share * (b.modulus - a.modulus)};
}

void WaterInPores::feel(const Assembly& a, Network& n, const HeatState& heat) const {
  for (std::int64_t d = 1; d < n.domain_count(); ++d) {
    if (!n.is_own(static_cast<std::size_t>(d)))
      continue;  // a pore that a well feeds by now keeps what it had grown by
    const State water = at(heat.fluid[d]);
    const bool joint = !n.joint_pore.empty() && n.joint_pore[static_cast<std::size_t>(d)] != 0;
    const double fluid =
        joint ? n.storing_at_start[d] : n.volume[d];  // the rest of what stores is the grains'
    double grown = (water.room - 1.0) * std::max(0.0, fluid + n.content[d]);
    for (auto k = n.corner_start[d]; !joint && !a.thermal.growth.empty() && k < n.corner_start[d + 1]; ++k)
      grown += sector_[k] * a.thermal.growth[n.corner_disc[k]];
    n.growth[d] = grown;
    n.storing[d] = n.storing_at_start[d] + fluid * (modulus_at_start_ / water.modulus - 1.0);
    if (n.stiffness[d] > 0.0) n.stiffness[d] = modulus_at_start_ / n.storing[d];
  }
}

}  // namespace hfrac
