// SPDX-License-Identifier: BSD-3-Clause
// The solid: discs and the bonds between them, as plain arrays.
//
// Positions are kept as reference (at bonding) plus displacement, so that gaps of a ten-thousandth of a disc lose no digits.
// A bond and the contact of the same two discs share one entry: the bond is there while `intact` is 1, the contact
// always (contact.mode = parallel) or once the bond broke (after-break). The law stands in solid/kernels_law.hpp.
#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include "core/array.hpp"
#include "geom/contact_graph.hpp"
#include "model/bond_factors.hpp"
#include "model/bond_geometry.hpp"
#include "model/smooth_contacts.hpp"
#include "model/softening.hpp"
#include "options/options.hpp"

namespace hfrac {

// What temperature makes of the discs (lib/heat); a pair of them, bonded or only touching, takes the mean of its two. All
// arrays are empty in a model without temperature, and whoever asks then gets nothing grown and factors of 1.
struct ThermalState {
  Array<double> growth;  // m, of the discs' radii since the initial equilibration
  Array<double> stiffness_factor, strength_factor, friction_factor;  // per disc, over the values given

  [[nodiscard]] bool empty() const { return growth.empty(); }
  [[nodiscard]] double growth_of(std::int64_t disc) const { return empty() ? 0.0 : growth[disc]; }
  [[nodiscard]] double strain_of(std::int64_t disc, const Array<double>& radius) const {
    return empty() ? 0.0 : growth[disc] / radius[disc];
  }
  [[nodiscard]] double pair_stiffness(std::int64_t i, std::int64_t j) const {
    return pair_mean(stiffness_factor, i, j);
  }
  [[nodiscard]] double pair_friction(std::int64_t i, std::int64_t j) const {
    return pair_mean(friction_factor, i, j);
  }
  [[nodiscard]] double pair_strength(std::int64_t i, std::int64_t j) const {
    return pair_mean(strength_factor, i, j);
  }

 private:
  [[nodiscard]] double pair_mean(const Array<double>& share, std::int64_t i, std::int64_t j) const {
    return empty() ? 1.0 : 0.5 * (share[i] + share[j]);
  }
};

struct Assembly {
  // discs
  Array<double> x, y, radius;                             // m, at bonding
  Array<double> ux, uy, rotation;                         // m, m, rad since bonding
  Array<double> vx, vy, spin;                             // m/s, rad/s (per unit of the solver's step)
  Array<double> external_x, external_y, external_moment;  // N, N, N m: far field, walls, non-bonded contacts
  // bonds, in the order of contact_graph.hpp: those inside tiles first, then those across, each in parts
  std::vector<std::int32_t> first, second;
  BondGeometry geometry;
  Array<std::uint8_t> intact;
  Array<double> slip;  // m
  Softening softening;
  ThermalState thermal;
  BondFactors factors;  // of toughness, joints and temperature together (bond_factors.hpp)
  std::vector<std::int64_t> part_first_bond;  // as of the edges of ContactGraph
  std::vector<std::int32_t> tile_first_pair;  // likewise
  double mean_radius = 0.0;                   // m; of a graded packing that of its fine discs
  Grading sizes;                              // of a graded packing
  double density = 0.0;                       // kg/m3
  double strength_factor = 1.0;               // strengths used over strengths given
  double tensile_per_radius = 0.0;            // N per metre of bond radius: 2 sigma_c, unit thickness
  double shear_per_radius = 0.0;              // 2 tau_c
  Array<double> strength_scale;  // per bond, on top of the two above; empty: 1 (solid/toughness.hpp)

  // of joints (solid/joints.hpp); empty without
  JointBonds joints;
  SmoothJoints smooth;

  [[nodiscard]] std::int64_t disc_count() const { return static_cast<std::int64_t>(x.size()); }
  [[nodiscard]] std::int64_t bond_count() const { return static_cast<std::int64_t>(first.size()); }
  // Of a bond, as bond_geometry.hpp has it [m].
  [[nodiscard]] double dx(std::int64_t bond) const { return geometry.at(part_of(bond), bond, block_dx); }
  [[nodiscard]] double dy(std::int64_t bond) const { return geometry.at(part_of(bond), bond, block_dy); }
  [[nodiscard]] double length(std::int64_t bond) const {
    return geometry.at(part_of(bond), bond, block_length);
  }
  [[nodiscard]] double arm(std::int64_t bond) const { return geometry.at(part_of(bond), bond, block_arm); }
  [[nodiscard]] double bond_radius(std::int64_t bond) const {
    return geometry.at(part_of(bond), bond, block_radius);
  }
  [[nodiscard]] std::size_t tile_count() const { return tile_first_pair.size() - 1; }
  [[nodiscard]] std::int64_t first_cross_bond() const { return part_first_bond[tile_count()]; }
  [[nodiscard]] std::size_t part_of(std::int64_t bond) const {
    const auto tile = static_cast<std::size_t>(first[bond] / tile_size);
    if (bond < first_cross_bond()) return tile;
    auto pair = static_cast<std::size_t>(tile_first_pair[tile]);
    while (part_first_bond[pair + 1] <= bond) ++pair;
    return pair;
  }
  [[nodiscard]] Vec2 position(std::int64_t disc) const { return {x[disc] + ux[disc], y[disc] + uy[disc]}; }
  // Per metre thickness: kg, and kg m2 as of a cylinder about its axis.
  [[nodiscard]] double mass(std::int64_t disc) const {
    return density * std::numbers::pi * radius[disc] * radius[disc];
  }
  [[nodiscard]] double inertia(std::int64_t disc) const {
    return 0.5 * mass(disc) * radius[disc] * radius[disc];
  }
  [[nodiscard]] double tensile_capacity(std::int64_t bond) const {
    return tensile_per_radius * bond_radius(bond) * factors.tensile_of(bond);
  }
  [[nodiscard]] double shear_capacity(std::int64_t bond) const {
    return shear_per_radius * bond_radius(bond) * factors.shear_of(bond);
  }
  [[nodiscard]] double pipe_length(std::int64_t bond) const {  // m: R_i + R_j (eq. 6)
    return radius[first[bond]] + radius[second[bond]];
  }
  [[nodiscard]] Vec2 contact_point(std::int64_t bond) const {  // m, at bonding
    const double share = arm(bond) / length(bond);
    return {x[first[bond]] + share * dx(bond), y[first[bond]] + share * dy(bond)};
  }
  // Mean radius of the discs around a place and around a bond, and of the coarsest [m].
  [[nodiscard]] double mean_radius_at(Vec2 place) const {
    return sizes.graded() ? sizes.at(place) : mean_radius;
  }
  [[nodiscard]] double mean_radius_of(std::int64_t bond) const {
    return sizes.graded() ? sizes.at(contact_point(bond)) : mean_radius;
  }
  [[nodiscard]] double coarsest_radius() const { return sizes.graded() ? sizes.coarsest() : mean_radius; }
  // What the joint that crosses a bond makes of it (nullptr: none does), and its normal there, unit, towards the bond's second disc.
  [[nodiscard]] const JointLaw* joint_law_of(std::int64_t bond) const {
    const auto joint = joints.joint_of(bond);
    return joint < 0 ? nullptr : &smooth.law_of_joint(joint);
  }
  [[nodiscard]] Vec2 joint_normal(std::int64_t bond) const {
    if (const SmoothContact* contact = smooth.of(bond)) return contact->normal;
    const Vec2 normal = joints.normal[static_cast<std::size_t>(joints.joint_of(bond))];
    return dot(normal, {dx(bond), dy(bond)}) > 0.0 ? normal : -1.0 * normal;
  }
  // The bond of two discs, -1 if they have none.
  [[nodiscard]] std::int64_t bond_between(std::int32_t i, std::int32_t j) const;
};

// Takes the graph over. Strengths are those given: solid/toughness.hpp makes them follow a fracture toughness.
Assembly build_assembly(ContactGraph graph, const Options& options);

}  // namespace hfrac
