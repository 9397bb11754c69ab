// SPDX-License-Identifier: BSD-3-Clause
// The law of one facet of a fracture: what its two discs answer to where they stand and to the fluid between them.
//
// frac/facets.hpp says what facets are and what they start from. Both solvers take their forces from here: the quasi-static one with the
// tangent (equilibrium/bond_response.cpp), the explicit one in every cycle (solid/facet_motion.hpp). With the push
// P = p_A L_A + p_B L_B of the fluid across the facet:
//   opening   w = n.(du - du_0 - g) + (P - n.F_0) / k_n,  g what the two discs have grown by with temperature along the line between
//             their centres (model/bond_factors.hpp): where rock shrinks without stress no fracture opens, and where it is held one does
//   open      w >= 0: no more than the fluid's push and the locked-in force
//   closed    n.F_0 - k_n n.(du - du_0) pressed together, and along it k_s times the slide less t.F_0, at most mu times what it
//             transmits beyond P, which is -k_n w
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/array.hpp"
#include "model/assembly.hpp"
#include "options/options.hpp"

namespace hfrac {

struct Facet {
  std::int64_t bond = -1;
  std::int32_t left = 0, right = 0;  // pores
  Vec2 normal;                       // unit, of the fracture around it, towards the second disc
  double length = 0.0;               // m, along the fracture
  double way = 0.0;                  // m, that its fluid flows
  double left_length = 0.0, right_length = 0.0;
  double initial_normal = 0.0, initial_shear = 0.0;  // N: of F_0, along n and (-n.y, n.x)
  Vec2 locked;                                       // N on the first disc while open
  double locked_first = 0.0, locked_second = 0.0;    // N m, as BondResponse::force[2], [3]
  double initial_energy = 0.0;                       // J/m, of the bond and its contact
  Vec2 middle;                                       // m
  bool slot = false;  // cut, not broken: the fluid passes whether the rock opens it or not
  std::int32_t corner[4] = {-1, -1, -1, -1};  // of left pore: first, second disc; of right pore
};

// The state that facets count from.
struct FacetStart {
  Array<double> x, y, rotation;  // m, m, rad: displacements of the discs
  double stiffness = 0.0;        // k_n, N/m
};

// m; g along `way`.
inline double facet_growth(const Assembly& a, std::int64_t bond, Vec2 way) {
  const double growth = a.factors.growth_of(bond);
  return growth == 0.0 ? 0.0 : growth * dot({a.dx(bond), a.dy(bond)}, way) / a.length(bond);
}

// m; n.(du - du_0 - g) along `way`.
inline double facet_jump(const Assembly& a, const FacetStart& s, const Facet& f, Vec2 way) {
  const auto i = a.first[f.bond], j = a.second[f.bond];
  return dot({a.ux[j] - s.x[j] - (a.ux[i] - s.x[i]), a.uy[j] - s.y[j] - (a.uy[i] - s.y[i])}, way) -
         facet_growth(a, f.bond, way);
}

// m; `push`: the fluid's [N].
inline double facet_opening(const Assembly& a, const FacetStart& s, const Facet& f, double push) {
  return facet_jump(a, s, f, f.normal) + (push - f.initial_normal) / s.stiffness;
}

// m, of its faces along it.
inline double facet_slide(const Assembly& a, const FacetStart& s, const Facet& f) {
  const auto i = a.first[f.bond], j = a.second[f.bond];
  const double arm_i = a.arm(f.bond), arm_j = a.length(f.bond) - arm_i;
  return facet_jump(a, s, f, {-f.normal.y, f.normal.x}) - arm_i * (a.rotation[i] - s.rotation[i]) -
         arm_j * (a.rotation[j] - s.rotation[j]);
}

// What a facet whose opening is below 0 transmits.
struct ClosedFacet {
  double normal, shear;  // N, tension positive
  double slides = 0.0;   // the sign of its shear force where friction limits it, else 0
};
inline ClosedFacet closed_facet(const Assembly& a, const Options& o, const FacetStart& s, const Facet& f,
                                double opening) {
  ClosedFacet c{s.stiffness * facet_jump(a, s, f, f.normal) - f.initial_normal, 0.0};
  // The grains bear what the facet transmits beyond the fluid's push, -k_n w: nothing where the facet opens.
  const double limit = -o.contact_friction * s.stiffness * opening;
  c.shear = o.contact_shear_stiffness * facet_slide(a, s, f) - f.initial_shear;
  if (std::abs(c.shear) > limit) {
    c.slides = std::copysign(1.0, c.shear);
    c.shear = std::copysign(limit, c.shear);
  }
  return c;
}

// J/m: the potential of a constant force on the first disc of a bond, and the opposite on the second.
inline double push_energy(const Assembly& a, const FacetStart& s, std::int64_t bond, Vec2 force) {
  const auto i = a.first[bond], j = a.second[bond];
  return dot(force, {a.ux[j] - s.x[j] - (a.ux[i] - s.x[i]), a.uy[j] - s.y[j] - (a.uy[i] - s.y[i])});
}

// J/m, of a facet: what its bond stored at the start, and what the half discs at its faces, its shear spring and the potential of the force
// that is locked in have taken up since. In motion discs and fluid do no other work on it than this, and friction:
// P dw = T dj + d(T^2 / 2 k_n) with T = P where it is open. A facet that is shut as it was stores what its bond did.
inline double facet_energy(const Assembly& a, const Options& o, const FacetStart& s, const Facet& f,
                           double push) {
  const auto i = a.first[f.bond], j = a.second[f.bond];
  const double k_s = o.contact_shear_stiffness;
  double energy = f.initial_energy + push_energy(a, s, f.bond, f.locked) +
                  f.locked_first * (a.rotation[i] - s.rotation[i]) +
                  f.locked_second * (a.rotation[j] - s.rotation[j]);
  const double opening = facet_opening(a, s, f, push);
  const ClosedFacet c = opening < 0.0 ? closed_facet(a, o, s, f, opening) : ClosedFacet{-push, 0.0};
  energy += 0.5 * (c.normal * c.normal - f.initial_normal * f.initial_normal) / s.stiffness;
  if (k_s > 0.0) energy += 0.5 * (c.shear * c.shear - f.initial_shear * f.initial_shear) / k_s;
  return energy;
}

// Whether a bond is a tip's: within the zone of it, on its side of joints, where the tip's stress reaches the rock's strength sigma_c at
// K_Ic, so that K_Ic alone is the strength there. The largest principal stress is at most 1.3 K_Ic / sqrt(2 pi r), at 60 degrees from the fracture's line.
inline double tip_zone(const Assembly& a, const Options& o) {
  constexpr double at_60_degrees = 1.299038105676658;  // 3 sqrt(3) / 4
  const double root = at_60_degrees * o.bond_fracture_toughness / (0.5 * a.tensile_per_radius);
  return root * root / (2.0 * std::numbers::pi);
}
inline bool in_tip_zone(const Assembly& a, double zone, Vec2 tip, std::int64_t bond) {
  const auto i = a.first[bond];
  const double share = a.arm(bond) / a.length(bond);
  const Vec2 at{a.x[i] + share * a.dx(bond), a.y[i] + share * a.dy(bond)};
  return norm(at - tip) < zone && !a.smooth.separate(at, tip);
}

}  // namespace hfrac
