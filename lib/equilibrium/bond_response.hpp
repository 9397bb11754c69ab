// SPDX-License-Identifier: BSD-3-Clause
// What a bond or contact answers to a displacement: its forces, and how they change (the tangent).
//
// The law is bond_law.hpp. A pair of discs knows only d = x_j - x_i and the two rotations, so its answer is a
// vector of four, q = (d_x, d_y, theta_i, theta_j), and its tangent four by four:
//   gradient  along d: N n + S (L0/L) t     theta_i: -(S a_i + M)     theta_j: -(S a_j - M)
//   tangent   dN/dg n n + dS/du_s (L0/L)^2 t t + dS/dg (L0/L) t n + N t t / L - S (L0/L^2) (n t + t n), and so on
// N is tension positive; S and M as in eq. 16-20. A sliding contact has dS/du_s = 0 and dS/dg from Coulomb's law, which makes
// its tangent unsymmetric.
#pragma once

#include <array>

#include "frac/facets.hpp"
#include "model/assembly.hpp"
#include "options/options.hpp"
#include "solid/non_bonded_contacts.hpp"

namespace hfrac {

struct BondResponse {
  double force[4];                                           // gradient with respect to q: N, N, N m, N m
  double tangent[16];                                        // row by row
  double gap = 0.0;                                          // m
  double normal = 0.0, shear = 0.0, normal_stiffness = 0.0;  // N tension positive, N, N/m
  Vec2 direction;                                            // from first to second disc
  double by_push = 0.0;  // of a facet that slides: shear force by the fluid's push across it
};

// With the slip as it stands; nothing is changed.
BondResponse respond(const Assembly& assembly, const Options& options, std::int64_t bond);

// A contact that was never bonded. `moved` = u, theta of both discs when its shear force was last kept: u_s counts from there.
struct PairStart {
  Vec2 between;                      // d then
  double first = 0.0, second = 0.0;  // rotations then
};
BondResponse respond(const Assembly& assembly, const Options& options, const NonBondedContacts::Pair& pair,
                     const PairStart& start);

// An open or closed facet of a fracture (frac/facets.hpp): its discs' forces but for the fluid's while open.
BondResponse respond(const Assembly& assembly, const Options& options, const Network& network,
                     const Facets& facets, const Facet& facet);

}  // namespace hfrac
