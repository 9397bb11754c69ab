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

// A disc that walls press on.
struct DeviceWallDisc {
  int64_t disc;
  double growth;  // m, by temperature
};

struct DeviceWall {
  int64_t first, last;  // in wall_discs
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
  // buffer; corners of the tile's pores
  const int32_t *bond_start, *slot_start, *corner_start;
  const uint16_t* bond_of;
  const DeviceCorner* corner_of;
  double* held_force;  // N, N, N m by disc: of tiles that did not move since a bond exceeds its strength
  int64_t* stop;       // the stage in which such a bond was found; stages after it do nothing
  // boundary and non-bonded contacts
  double *external_x, *external_y, *external_moment;  // those of `a`, to write
  DeviceOutside* outside;
  const DeviceWallDisc* wall_discs;
  int64_t wall_disc_count, walled, servo;
  double wall_stiffness;  // N/m
  double* wall_force;     // N, by wall disc
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
  double motion[6];      // device_take_out: Boundary::RigidMotion
};

constexpr int64_t most_tile_bonds = 3 * tile_size;  // a planar graph has no more edges

// Bytes of a block's own memory for a kernel, given the largest number of bonds and of pores of a tile.
constexpr int64_t device_shared_bytes(int32_t kernel, int64_t bonds, int64_t domains) {
  const int64_t sums = 64;
  const int64_t doubles = kernel == device_tile_step     ? 4 * tile_size + 6 * bonds + domains + sums
                          : kernel == device_tile_move   ? 4 * tile_size + sums
                          : kernel == device_momenta     ? 6 * tile_size
                          : kernel == device_look_over   ? tile_size + sums
                          : kernel == device_cross_pairs ? 2 * 64 + sums
                          : kernel == device_cross_pores ? domains + sums
                                                         : sums;
  return doubles * static_cast<int64_t>(sizeof(double));
}

}  // namespace hfrac
