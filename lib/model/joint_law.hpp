// SPDX-License-Identifier: BSD-3-Clause
// What a joint is made of, most of it a smooth one's: closure, friction, dilation, aperture. All per area, free of the size of discs.
//
//   closure     sigma_n = k_n d / (1 - d / d_m)   (Bandis, Lumsden and Barton 1983), d how far the faces are pressed together since they
//               bore nothing; linear where no largest closure d_m is given, and beyond the stress `highest`
//   friction    tau <= mu(s) sigma_n, mu from peak to residual in proportion to the slip s, over the weakening slip (Ida 1972)
//   dilation    D(s) = min(|s|, s_d) tan psi: the faces ride up on each other, and down again where they slip back
//   opening     U = D - d, or more where the faces part
//   aperture    mechanical e = max(0, e_0 + U), with e_0 that of faces which just touch; hydraulic w = e, or with a roughness
//               coefficient J  min(e, e^2 / J^2.5), e and w in micrometres (Barton, Bandis and Bakhtar 1985); and a residual w on top,
//               which closed faces keep
#pragma once

#include <algorithm>
#include <cmath>

namespace hfrac {

struct JointLaw {
  double normal_stiffness = 0.0, shear_stiffness = 0.0;  // Pa/m, k_n at no stress
  double max_closure = 0.0;                              // m, d_m; 0: none
  double highest = 0.0;                                  // Pa
  double tensile_strength = 0.0, cohesion = 0.0;         // Pa, while it holds; 0: of its bonds
  double friction = 0.0;                                 // 1, peak
  double residual_friction = 0.0, weakening_slip = 0.0;  // 1, m; no such slip: friction stays
  double dilation = 0.0, dilation_slip = 0.0;            // 1, tan psi; m, s_d
  double aperture = 0.0, residual_aperture = 0.0;        // m, e_0; hydraulic
  double roughness = 0.0;                                // 1, J; 0: smooth
  double storage = 0.0;                                  // m/Pa, of pores and small fractures beside it
  double tensile_factor = 1.0, shear_factor = 1.0;       // of its bonds' strengths

  // Whether fluid flows along it by its own aperture; otherwise as through any broken bond.
  [[nodiscard]] bool conducts() const { return aperture > 0.0 || residual_aperture > 0.0; }
  [[nodiscard]] bool follows_slip() const { return dilation > 0.0 || weakening_slip > 0.0; }
  bool operator==(const JointLaw&) const = default;
};

// A value and its change with what it depends on.
struct JointValue {
  double value, slope;
};

// In the header since the step loop asks for them at every contact.

// Closure at which a joint bears `highest`: from there on it is linear.
inline double last_closure(const JointLaw& law) {
  return law.highest / (law.normal_stiffness + law.highest / law.max_closure);
}
// Pa, Pa/m; 0 where it is negative.
inline JointValue closure_stress(const JointLaw& law, double closure) {
  if (closure <= 0.0) return {0.0, 0.0};
  if (law.max_closure <= 0.0) return {law.normal_stiffness * closure, law.normal_stiffness};
  const double d = std::min(closure, last_closure(law)), room = 1.0 - d / law.max_closure;
  const double slope = law.normal_stiffness / (room * room);
  return {law.normal_stiffness * d / room + slope * (closure - d), slope};
}

// 1, 1/m by the signed slip.
inline JointValue joint_friction(const JointLaw& law, double friction, double slip) {
  if (law.weakening_slip <= 0.0) return {friction, 0.0};
  if (std::abs(slip) >= law.weakening_slip) return {law.residual_friction, 0.0};
  const double slope = (law.residual_friction - friction) / law.weakening_slip;
  return {friction + slope * std::abs(slip), slip < 0.0 ? -slope : slope};
}

// m, 1.
inline JointValue joint_dilation(const JointLaw& law, double slip) {
  if (std::abs(slip) >= law.dilation_slip) return {law.dilation * law.dilation_slip, 0.0};
  return {law.dilation * std::abs(slip), std::copysign(law.dilation, slip)};
}

double closure_energy(const JointLaw& law, double closure);      // J/m2
double stiffest(const JointLaw& law);                            // Pa/m, up to `highest`
JointValue joint_aperture(const JointLaw& law, double opening);  // m, 1

}  // namespace hfrac
