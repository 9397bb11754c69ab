// SPDX-License-Identifier: BSD-3-Clause
// The step loop's three passes over raw arrays, compiled for several instruction sets from one source.
//
//   bond pass     displacements -> force and moment of every bond and contact, breakage flags       (writes force[e])
//   disc pass     forces of its bonds, pressures of its domains, external forces -> new velocity and displacement
//   domain pass   displacements of its corner discs -> change of volume -> undrained pressure
//
// Every pass gathers: an item adds up what acts on it in a fixed order, nothing is scattered, so any number of workers
// gives the same bits. Sums for the balances are kept per block of `kernel_block` items and added in block order.
// This header and the sources behind it include no standard templates: they are compiled with wider instructions
// than the rest, and an inline function from here must never be the one the linker keeps for the whole library.
#pragma once

#include <stdint.h>  // NOLINT(modernize-deprecated-headers): see above

namespace hfrac {

constexpr int64_t kernel_block = 256;

// Force of one bond on its discs: force on disc i (disc j gets the opposite), moment on i, moment on j.
struct alignas(32) BondForce {
  double fx, fy, moment_i, moment_j;
};

struct BlockSums {
  double force;     // sum of |fx| + |fy|: contact forces (bond pass), unbalanced forces (disc pass)
  double work;      // friction (bond pass), damping (disc pass), work of the fluid on the discs (domain pass)
  int64_t flagged;  // bond pass: 1 if some bond of the block exceeds its strength
};

struct KernelArrays {
  // discs, since bonding
  double *ux, *uy, *rotation;  // m, m, rad
  double *vx, *vy, *spin;      // per unit of `step`
  const double *inverse_mass, *inverse_inertia;
  const double *external_x, *external_y, *external_moment;  // N, N, N m: far field, walls, loose contacts
  int64_t disc_count;
  // bonds, sorted by first disc
  const int32_t *first, *second;
  const double *dx, *dy, *length;  // m: centre to centre at bonding
  const double* arm;               // m: from the first disc's centre to the contact point at bonding
  const double* bond_radius;       // m
  const double* intact;            // 1, or 0 once broken
  const double* tensile_capacity;  // N: sigma_c A
  const double* shear_capacity;    // N: tau_c A
  double* slip;                    // m: shear displacement the contact has slid through
  BondForce* force;
  int64_t bond_count;
  // the bonds of each disc: 2 * bond + (1 if the disc is the second one)
  const int32_t *incidence_start, *incidence;
  // the domains around each disc: weight dV/du of eq. 10
  const int32_t *disc_corner_start, *disc_corner_domain;
  const double* disc_corner_weight;  // m: x, y per corner
  // the discs around each domain, same weights
  const int32_t *domain_corner_start, *domain_corner_disc;
  const double* domain_corner_weight;
  double* pressure;         // Pa
  double* volume_change;    // m2 since bonding
  const double* content;    // m2: fluid taken in, at reference pressure
  const double* stiffness;  // Pa/m2: K_f / V; 0 where the pressure is imposed
  int64_t domain_count;
  // constants
  double bond_normal, bond_shear;        // N/m: parallel bond stiffness times area
  double contact_normal, contact_shear;  // N/m
  double friction;
  double bending_share;                       // beta of eq. 21
  double contact_with_bond;                   // 1: contact beside an intact bond, 0: only after it broke
  double damping;                             // local damping
  double step;                                // s, or 1 with scaled masses
  double reference_pressure, floor_pressure;  // Pa
  int32_t with_pressure;                      // 0: no fluid forces
  // sums per block
  BlockSums *bond_sums, *disc_sums, *domain_sums;
};

// first and last are multiples of kernel_block, or the number of items.
struct KernelTable {
  void (*bond_pass)(const KernelArrays& a, int64_t first, int64_t last);
  void (*disc_pass)(const KernelArrays& a, int64_t first, int64_t last);
  void (*domain_pass)(const KernelArrays& a, int64_t first, int64_t last);
  const char* name;
};

// The widest set this processor can run; chosen once, never changes. HFRAC does not read the environment.
const KernelTable& kernels() noexcept;
const char* kernel_isa() noexcept;

// For tests and benchmarks: the table of an instruction set by name ("baseline", "avx2", "avx512"), or nullptr.
const KernelTable* kernels_for(const char* name) noexcept;

}  // namespace hfrac
