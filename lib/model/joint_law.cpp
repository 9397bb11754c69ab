// SPDX-License-Identifier: BSD-3-Clause
#include "model/joint_law.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

// J/m2, the integral of Bandis' stress.
double bandis_energy(const JointLaw& law, double d) {
  const double share = d / law.max_closure;
  return -law.normal_stiffness * law.max_closure * law.max_closure * (share + std::log1p(-share));
}

}  // namespace

double closure_energy(const JointLaw& law, double closure) {
  if (closure <= 0.0) return 0.0;
  if (law.max_closure <= 0.0) return 0.5 * law.normal_stiffness * closure * closure;
  const double d = std::min(closure, last_closure(law)), beyond = closure - d;
  const JointValue at = closure_stress(law, d);
  return bandis_energy(law, d) + at.value * beyond + 0.5 * at.slope * beyond * beyond;
}

double stiffest(const JointLaw& law) {
  return law.max_closure > 0.0 ? closure_stress(law, last_closure(law)).slope : law.normal_stiffness;
}

JointValue joint_aperture(const JointLaw& law, double opening) {
  const double e = law.aperture + opening;
  if (e <= 0.0) return {law.residual_aperture, 0.0};
  constexpr double micrometre = 1e-6;
  const double smooth_from = std::pow(law.roughness, 2.5) * micrometre;  // m: e at which e^2 / J^2.5 is e
  if (e >= smooth_from) return {law.residual_aperture + e, 1.0};
  return {law.residual_aperture + e * e / smooth_from, 2.0 * e / smooth_from};
}

}  // namespace hfrac
