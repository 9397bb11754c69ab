// SPDX-License-Identifier: BSD-3-Clause
// What the kernels of a device (gpu/device_kernels.hpp) read and write: the arrays of kernels.hpp, at addresses of the device, and what
// tells each of a thousand threads its own part of a sum that one worker adds up in order.
//
// A processor's worker adds forces to discs bond after bond. On a device every disc collects its own: the lists here say what adds to
// a disc, in the very order in which a worker would have added it, so both give the same bits.
// No standard templates here, see kernels.hpp.
#pragma once

#include "core/device_kernel.hpp"
#include "solid/kernels.hpp"

namespace hfrac {

// A corner of a pore that lies in one tile, of the disc whose list this stands in.
struct DeviceCorner {
  int32_t corner, domain;
};

// The bonds of a disc's tile that hold it, as in bond_of: eight numbers of 16 bits. If there are more than eight, the last says so.
struct DeviceBonds {
  uint64_t first, second;
};
constexpr int32_t disc_bonds = 8, no_bond = 0xffff, more_bonds = 0xfffe;

// A disc that one wall presses on, or two.
struct DeviceWallDisc {
  int32_t disc, wall[2],
      place[2];   // walls in their order, -1: none; where their forces on it go in wall_force
  double growth;  // m, by temperature
};

struct DeviceWall {
  int64_t first, last;  // in wall_force
  double inward_x, inward_y, displacement, velocity;
  double target;  // N: stress in force times length
  double floor;   // N: least that an imbalance is measured by
  double mass;    // kg, or by scaled masses
};

// A non-bonded contact; the force on its first disc goes to both discs' lists.
struct DevicePair {
  int32_t first, second;
  double normal, shear, friction;      // N/m, N/m, 1
  double growth_first, growth_second;  // m, by temperature
  double reference_gap, normal_force, shear_force;
  double on_first_x, on_first_y, arm_first, arm_second, friction_work;
  int64_t touches;
};

// A disc on which something pushes that changes with every cycle.
struct DevicePushedDisc {
  int64_t disc, first, last;  // its pairs, in pushed_pairs: 2 * pair + (0: it is the first, 1: the second)
  double load_x, load_y;      // N: the boundary's
  int64_t keeps_load;         // 1: a wall has written it in this cycle, 0: load_x, load_y
};

struct DeviceOutside {
  DeviceWall walls[4];
  double work, imbalance, friction;  // J/m, 1, J/m
};

struct DeviceArrays {
  KernelArrays a;
  // by disc: bonds of its tile, as 2 * (bond - first of the tile) + (0: it is the first disc, 1: the second); its slots in the force
  // buffer; corners of pores across tiles (a.cross_corner, which here goes disc by disc), and of the tile's
  const int32_t *bond_start, *slot_start, *cross_start, *corner_start;
  const uint16_t* bond_of;
  const DeviceBonds* bonds_of;
  const DeviceCorner* corner_of;
  const int32_t* large_pores;  // places in cross_domain of those of more corners than most_corners
  double* large_works;         // J/m, by place in cross_domain, of those
  double* held_force;  // N, N, N m by disc: of tiles that did not move since a bond exceeds its strength
  int64_t* stop;       // the stage in which such a bond was found; stages after it do nothing
  // boundary and non-bonded contacts
  double *external_x, *external_y, *external_moment;  // those of `a`, to write
  DeviceOutside* outside;
  const DeviceWallDisc* wall_discs;
  int64_t wall_disc_count, walled, servo;
  double wall_stiffness;  // N/m
  double* wall_force;     // N, by wall and disc
  DevicePair* pairs;
  int64_t contact_count, pushed_count;
  const DevicePushedDisc* pushed;
  const int32_t* pushed_pairs;
  const double *x, *y, *radius, *mass;  // m, m, m, kg
  // rigid motion of a model that nothing holds
  double centre_x, centre_y;
  double* momenta;  // six by tile
  double* looked;   // two by tile: J/m of motion; 1 if something is no number
};

// For which tiles, pairs or parts a kernel is launched, and what else it is told.
struct DeviceTask {
  DeviceArrays d;
  int64_t stage;         // of the batch: 2 cycle (bonds across tiles, boundary), 2 cycle + 1 (tiles)
  const int32_t* list;   // which, by block; null: all
  int64_t moves_anyway;  // device_tile_step: 1 whether or not bonds exceed their strength
  int64_t looks_only;    // likewise: 1 forces, pressures and volumes, no motion
  int64_t wants_forces;  // sums of sizes of forces, which the last cycle of a batch gives
  double motion[6];      // device_take_out: Boundary::RigidMotion
};

constexpr int32_t most_corners = 24;  // of a pore that one thread does
constexpr int64_t never_stopped = INT64_MAX;

constexpr int64_t most_tile_bonds = 3 * tile_size;  // a planar graph has no more edges

// Bytes of a block's own memory for a kernel, given the largest number of bonds and of pores of a tile.
constexpr int64_t device_shared_bytes(int32_t kernel, int64_t bonds, int64_t domains) {
  const int64_t sums = 64;
  const bool steps = kernel == device_tile_step || kernel == device_plain_tile_step,
             pairs = kernel == device_cross_pairs || kernel == device_plain_cross_pairs;
  const int64_t doubles = steps                          ? 4 * tile_size + 5 * bonds + 2 * domains + sums
                          : kernel == device_tile_move   ? 4 * tile_size + sums
                          : kernel == device_momenta     ? 6 * tile_size
                          : kernel == device_look_over   ? tile_size + sums
                          : pairs                        ? 3 * 64 + sums
                          : kernel == device_cross_pores ? domains + sums
                          : kernel == device_large_pores ? 2 * 1024 + sums
                                                         : sums;
  return doubles * static_cast<int64_t>(sizeof(double));
}

// What cards of compute capability 8.6 and 8.9 have for a block.
static_assert(device_shared_bytes(device_tile_step, most_tile_bonds, 2 * tile_size) <= 99 * 1024);

}  // namespace hfrac
