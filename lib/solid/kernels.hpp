// SPDX-License-Identifier: BSD-3-Clause
// The step loop over raw arrays, compiled for several instruction sets from one source.
//
// Discs go in tiles of `tile_size` neighbours (tiles.hpp). What lies inside one tile, bonds and pores, is done there and
// then: displacements come in once, forces add up in the scratch memory of the tile and never see main memory, the
// discs move.
//
//   cross_bonds, cross_domains   bonds and pores from a tile to later ones: forces into the inter-tile force buffer of their discs' tiles
//   tile_forces                  buffered forces, outside forces, then the tile's bonds and pores -> force on each of its discs
//   tile_move                    those forces -> new velocities and displacements
//
// Each tile is one worker's at a time and adds up in a fixed order, so any number of workers gives the same bits. Sums
// for the balances are kept per tile and added in the order of tiles.
// This header and the sources behind it include no standard templates: they are compiled with wider instructions
// than the rest, and an inline function from here must never be the one the linker keeps for the whole library.
#pragma once

#include <stdint.h>  // NOLINT(modernize-deprecated-headers): see above

#include "core/layout.hpp"

namespace hfrac {

// Force of one bond on its discs: force on disc i (disc j gets the opposite), moment on i, moment on j.
struct alignas(32) BondForce {
  double fx, fy, moment_i, moment_j;
};

// A force on its way to a disc of another tile.
struct alignas(32) BufferedForce {
  double fx, fy, moment;
  int64_t disc;
};

constexpr double steepest_softening = 1.05;  // least w_c / w_0 (softening.hpp)

// A smooth joint's law in the kernels: no dilation, constant friction (model/joint_law.hpp).
struct SmoothLaw {
  double normal, shear;                  // Pa/m
  double inverse_closure, last_closure;  // 1/m, m: 0 and beyond any where it is linear
  double friction;
  double tensile, cohesion, intact_friction;  // Pa, Pa, 1: of a contact that holds
};

// What a contact that the kernels do not know the law of does to its discs: as BondForce.
using SmoothForces = BondForce;

// The contacts of smooth joints, ascending by bond: they answer in place of their bonds (smooth_joints.hpp).
struct SmoothArrays {
  int64_t count;
  const void* contacts;       // SmoothContact; null: none
  const double* settled;      // SettledContact; null: none is
  const int32_t* law_number;  // by joint
  const SmoothLaw* laws;
  const SmoothForces* forces;  // by contact, where the kernels do not know the laws; else null
  const int64_t* from;         // the first contact of each tile, then of each pair of tiles
};

struct TileSums {
  double force;     // sum of |fx| + |fy|: contact forces (bonds), unbalanced forces (discs)
  double work;      // friction (bonds), damping (discs), work of the fluid on the discs (domains)
  int64_t flagged;  // bonds: 1 if some bond exceeds its strength
};

struct Tile {
  int64_t first_disc, last_disc, first_bond, last_bond, first_domain, last_domain;
  int64_t first_slot, last_slot;      // of its discs in the buffer of forces
  int64_t first_corner, last_corner;  // of its discs in `cross_corner`
  int64_t first_block;                // of its bonds
  int64_t left_alone;  // 1: nothing outside pushes its discs, and external_* need not be looked at
};

// The bonds between two tiles, and where their geometry begins.
struct TilePair {
  int64_t first_bond, last_bond, first_block;
};

// What lies across tiles and belongs to the first of them: pairs of it with later ones, and domains as places in `cross_domain`.
struct CrossPart {
  int64_t first_pair, last_pair, first_domain, last_domain;
};

// A corner of a domain that touches several tiles, as the tile of its disc finds it.
struct CrossCorner {
  int32_t disc, domain, corner;
};

struct KernelArrays {
  // discs, since bonding
  double *ux, *uy, *rotation;  // m, m, rad
  double *vx, *vy, *spin;      // per unit of `step`
  const double *inverse_mass, *inverse_inertia;
  const double *external_x, *external_y,
      *external_moment;  // N, N, N m: far field, walls, non-bonded contacts
  int64_t disc_count;
  // bonds: those inside tiles by tile, then those across
  const int32_t *first, *second;
  const double* geometry;  // m, in blocks of `block_values`
  const uint8_t* intact;   // 1, or 0 once broken
  double* slip;            // m: shear displacement the contact has slid through
  // by bond, all null where the rock is the same everywhere (bond_factors.hpp): thermal growth [m], factors of stiffness and
  // strengths, coefficient of friction
  const double *growth, *stiffness_factor, *tensile_factor, *shear_factor, *bond_friction;
  int64_t bond_count, first_cross_bond;
  SmoothArrays smooth;
  // the discs around each domain: weight dV/du of eq. 10
  const int32_t *domain_corner_start, *domain_corner_disc;
  const double* domain_corner_weight;  // m: x, y per corner
  const double* domain_corner_turn;    // m2; null: none
  double* pressure;                    // Pa
  double* volume_change;               // m2 since bonding
  const double* content;               // m2: fluid taken in, at reference pressure
  const double* stiffness;             // Pa/m2: K_f / V; 0 where the pressure is imposed
  // tiles
  const Tile* tiles;
  const TilePair* pairs;
  const CrossPart* cross_parts;  // by tile, and one for the outside
  int64_t tile_count, pair_count;
  const int32_t* cross_domain;  // domains that touch two tiles, by the first of them, and last the outside
  const CrossCorner* cross_corner;  // of those that push, by tile
  const int32_t* bond_slot;         // two places per bond across tiles: first disc, second disc
  BufferedForce* force_buffer;
  // constants
  double bond_normal, bond_shear;           // N/m: parallel bond stiffness times area
  double contact_normal, contact_shear;     // N/m
  double tensile_capacity, shear_capacity;  // N per metre of bond radius: 2 sigma_c, 2 tau_c
  double friction;
  double bending_share;                       // beta of eq. 21
  int32_t flat;                               // 1: contacts as wide as bonds, which bear moments
  double contact_with_bond;                   // 1: contact beside an intact bond, 0: only after it broke
  double damping;                             // local damping
  double step;                                // s, or 1 with scaled masses
  double reference_pressure, floor_pressure;  // Pa
  int32_t with_pressure;                      // 0: no fluid forces
  int32_t undrained;                          // 1: pressures follow the volumes of their pores
  // sums: of each tile, then of bonds by pair, of domains by part across
  TileSums *bond_sums, *disc_sums, *domain_sums;
  // by bond, null unless bonds soften (softening.hpp)
  double *softening_start, *softening_worst;  // m
  double softening;                           // N: w_0 w_c k_n per bond radius, 4 G_c
};

// Doubles of scratch memory that tile_forces and tile_move share, on a 64-byte boundary.
constexpr int64_t tile_scratch = 8 * tile_size;

struct KernelTable {
  void (*tile_forces)(const KernelArrays& a, int64_t tile, double* scratch);
  void (*tile_move)(const KernelArrays& a, int64_t tile, const double* scratch);
  void (*cross_bonds)(const KernelArrays& a, int64_t pair);
  void (*cross_domains)(const KernelArrays& a, int64_t part);
  // The forces of all bonds as they stand, for tests and whoever wants to look; moves and slides nothing.
  void (*bond_forces)(const KernelArrays& a, BondForce* to);
  const char* name;
};

// The widest set this processor can run; chosen once, never changes. HFRAC does not read the environment.
const KernelTable& kernels() noexcept;
const char* kernel_isa() noexcept;

// For tests and benchmarks: the table of an instruction set by name ("baseline", "avx2", "avx512"), or nullptr.
const KernelTable* kernels_for(const char* name) noexcept;

}  // namespace hfrac
