// SPDX-License-Identifier: BSD-3-Clause
#include "model/bond_factors.hpp"

#include "model/assembly.hpp"
#include "options/options.hpp"

namespace hfrac {
namespace {

// Smooth joints make no difference to the bonds: their contacts answer in place of them.
bool differ(const Assembly& a) {
  return !a.thermal.empty() || !a.strength_scale.empty() || !a.softening.empty() ||
         a.joints.joint.size() > a.smooth.contacts.size();
}

}  // namespace

void combine_factors(Assembly& a, const Options& o) {
  const ThermalState& thermal = a.thermal;
  if (!differ(a)) return;
  BondFactors& factors = a.factors;
  const std::size_t bonds = a.first.size();
  for (auto* values :
       {&factors.growth, &factors.stiffness, &factors.tensile, &factors.shear, &factors.friction})
    values->resize(bonds);
  for (std::size_t e = 0; e < bonds; ++e) {
    const std::int64_t i = a.first[e], j = a.second[e];
    const double arm_j = a.length(e) - a.arm(e);
    factors.growth[e] = thermal.strain_of(i, a.radius) * a.arm(e) + thermal.strain_of(j, a.radius) * arm_j;
    // A smooth joint's bond, in whose place its contact answers, does not soften either.
    const bool smooth = !a.softening.empty() && a.smooth.of(static_cast<std::int64_t>(e)) != nullptr;
    factors.stiffness[e] = smooth ? 0.0 : thermal.pair_stiffness(i, j);
    const JointLaw* joint = a.joint_law_of(static_cast<std::int64_t>(e));
    const double strength = thermal.pair_strength(i, j) *
                            (a.strength_scale.empty() ? 1.0 : a.strength_scale[e]) *
                            (a.softening.holds(static_cast<std::int64_t>(e)) ? never_breaks : 1.0);
    factors.tensile[e] = strength * (joint == nullptr ? 1.0 : joint->tensile_factor);
    factors.shear[e] = strength * (joint == nullptr ? 1.0 : joint->shear_factor);
    factors.friction[e] =
        (joint == nullptr ? o.contact_friction : joint->friction) * thermal.pair_friction(i, j);
  }
}

void refill_factors(Assembly& a, const Options& o) {
  combine_factors(a, o);
  if (differ(a)) return;
  BondFactors& factors = a.factors;
  factors.growth.assign(a.first.size(), 0.0);
  for (auto* values : {&factors.stiffness, &factors.tensile, &factors.shear})
    values->assign(a.first.size(), 1.0);
  factors.friction.assign(a.first.size(), o.contact_friction);
}

}  // namespace hfrac
