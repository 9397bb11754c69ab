// SPDX-License-Identifier: BSD-3-Clause
#include "model/joint_law.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

// Closure at which a joint bears `highest`: from there on it is linear.
double last_closure(const JointLaw& law) {
  return law.highest / (law.normal_stiffness + law.highest / law.max_closure);
}
// J/m2, the integral of Bandis' stress.
double bandis_energy(const JointLaw& law, double d) {
  const double share = d / law.max_closure;
  return -law.normal_stiffness * law.max_closure * law.max_closure * (share + std::log1p(-share));
}

}  // namespace

JointValue closure_stress(const JointLaw& law, double closure) {
  if (closure <= 0.0) return {0.0, 0.0};
  if (law.max_closure <= 0.0) return {law.normal_stiffness * closure, law.normal_stiffness};
  const double d = std::min(closure, last_closure(law)), room = 1.0 - d / law.max_closure;
  const double slope = law.normal_stiffness / (room * room);
  return {law.normal_stiffness * d / room + slope * (closure - d), slope};
}

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

JointValue joint_friction(const JointLaw& law, double friction, double slip) {
  if (law.weakening_slip <= 0.0) return {friction, 0.0};
  if (std::abs(slip) >= law.weakening_slip) return {law.residual_friction, 0.0};
  const double slope = (law.residual_friction - friction) / law.weakening_slip;
  return {friction + slope * std::abs(slip), slip < 0.0 ? -slope : slope};
}

JointValue joint_dilation(const JointLaw& law, double slip) {
  if (std::abs(slip) >= law.dilation_slip) return {law.dilation * law.dilation_slip, 0.0};
  return {law.dilation * std::abs(slip), std::copysign(law.dilation, slip)};
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
