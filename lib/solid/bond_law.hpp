// SPDX-License-Identifier: BSD-3-Clause
// The law of one bond and its contact, in scalars: what a pair of discs answers to where it stands.
//
// The kernels work through the same law 64 bonds at a time; kernels_law.hpp states it with its sources, and tests/unit/kernels_test.cpp
// holds the two together. Everything else that asks for a bond's forces asks here: where a bond breaks (BondView::breaks), logs, fields,
// energies, and the tangent of the quasi-static solver (equilibrium/bond_response.hpp).
#pragma once

#include <cstdint>

#include "model/assembly.hpp"
#include "options/options.hpp"
#include "solid/softening.hpp"

namespace hfrac {

// How a pair stands to each other since bonding.
struct PairMotion {
  Vec2 normal;          // from first to second disc, now
  double now, length;   // m, distance of the centres, now and at bonding
  double arm_i, arm_j;  // m, from each centre to the contact at bonding
  double gap;           // m, positive: open
  double shear;         // m
  double bend;          // rad
};

// Forces and stiffnesses of bond and contact; a bond that is broken, or a contact that is open, has none.
struct BondLaw {
  PairMotion motion;
  double bond_normal = 0.0, bond_shear = 0.0, bond_moment = 0.0;  // N tension positive, N, N m
  double bond_stiffness = 0.0, bond_shear_stiffness = 0.0, bond_moment_stiffness = 0.0;  // N/m, N/m, N m
  double contact_normal = 0.0, contact_shear = 0.0;               // N compression positive, N
  double contact_stiffness = 0.0, contact_shear_stiffness = 0.0;  // N/m, of a contact that is there
  double contact_moment = 0.0, contact_moment_stiffness = 0.0,
         contact_coupling =
             0.0;               // N m, N m, N: of a flat one; its moment by the gap, and its pull by the bend
  double contact_energy = 0.0;  // J/m, of pressure
  Softened softened;            // stiffnesses above are those of what is left of it
  double friction = 0.0;
  bool pressed = false;  // the contact is there and closed, at least in part
  bool slides = false;   // its shear force is at the Coulomb limit
};
BondLaw bond_law(const Assembly& assembly, const Options& options, std::int64_t bond);

// One bond as it stands, of a smooth joint or not, with its energy and how far it is stressed (not for the step loop).
struct BondView {
  double gap;             // m, positive: open
  double shear;           // m, relative shear displacement
  Vec2 normal;            // from first to second disc, now; of a smooth joint: its own
  Vec2 first_arm;         // m, from the first disc's centre to the contact
  Vec2 second_arm;        // m, from the second disc's
  double bond_normal;     // N, tension positive
  double bond_shear;      // N
  double bond_moment;     // N m
  double contact_moment;  // N m, of a flat contact
  double contact_normal;  // N, compression positive
  double contact_shear;   // N
  double bond_energy;     // J/m, elastic
  double contact_energy;  // J/m
  double
      tensile_excess;  // stress over strength, eq. 21 and 23; of a bond that softens, opening over the one at which it is broken
  double shear_excess;  // stress over strength, eq. 22 and 23
  // Where a bond breaks: at its strength in tension with bending, or in shear (eq. 21-23).
  [[nodiscard]] bool breaks() const { return tensile_excess >= 1.0 || shear_excess >= 1.0; }
  [[nodiscard]] double normal_force() const { return bond_normal - contact_normal; }
  [[nodiscard]] double shear_force() const { return bond_shear + contact_shear; }
};
BondView view_bond(const Assembly& assembly, const Options& options, std::int64_t bond);

// Of a view only what an aperture follows from, for all bonds in every step. part: that of the bond (Assembly::part_of).
struct NormalView {
  double gap, force;  // m, positive: open; N, of bond and contact, tension positive
};
NormalView view_normal(const Assembly& assembly, const Options& options, std::size_t part, std::int64_t bond);

}  // namespace hfrac
