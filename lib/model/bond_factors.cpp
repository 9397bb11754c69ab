// SPDX-License-Identifier: BSD-3-Clause
#include "model/bond_factors.hpp"

#include "model/assembly.hpp"
#include "options/options.hpp"

namespace hfrac {

void combine_factors(Assembly& a, const Options& o) {
  const ThermalState& thermal = a.thermal;
  if (thermal.empty() && a.strength_scale.empty() && a.joint_tensile.empty() && a.softening.empty()) return;
  BondFactors& factors = a.factors;
  const std::size_t bonds = a.first.size();
  for (auto* values :
       {&factors.growth, &factors.stiffness, &factors.tensile, &factors.shear, &factors.friction})
    values->resize(bonds);
  for (std::size_t e = 0; e < bonds; ++e) {
    const std::int64_t i = a.first[e], j = a.second[e];
    const double arm_j = a.length(e) - a.arm(e);
    factors.growth[e] = thermal.strain_of(i, a.radius) * a.arm(e) + thermal.strain_of(j, a.radius) * arm_j;
    // The law of smooth joints stands by itself (smooth_joints.hpp): for all others there is no contact here.
    const bool smooth = a.smooth.of(static_cast<std::int64_t>(e)) != nullptr;
    factors.stiffness[e] = smooth ? 0.0 : thermal.pair_stiffness(i, j);
    const double strength = thermal.pair_strength(i, j) *
                            (a.strength_scale.empty() ? 1.0 : a.strength_scale[e]) *
                            (a.softening.holds(static_cast<std::int64_t>(e)) ? never_breaks : 1.0);
    factors.tensile[e] = strength * (a.joint_tensile.empty() ? 1.0 : a.joint_tensile[e]);
    factors.shear[e] = strength * (a.joint_shear.empty() ? 1.0 : a.joint_shear[e]);
    factors.friction[e] =
        (a.joint_friction.empty() ? o.contact_friction : a.joint_friction[e]) * thermal.pair_friction(i, j);
  }
}

void refill_factors(Assembly& a, const Options& o) {
  combine_factors(a, o);
  if (!a.thermal.empty() || !a.strength_scale.empty() || !a.joint_tensile.empty() || !a.softening.empty())
    return;
  BondFactors& factors = a.factors;
  factors.growth.assign(a.first.size(), 0.0);
  for (auto* values : {&factors.stiffness, &factors.tensile, &factors.shear})
    values->assign(a.first.size(), 1.0);
  factors.friction.assign(a.first.size(), o.contact_friction);
}

}  // namespace hfrac
