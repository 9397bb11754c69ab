// SPDX-License-Identifier: BSD-3-Clause
// A tile of discs on a device: its bonds and pores answer, every disc collects its forces, moves, and sums are made.
#pragma once

#include "gpu/device_bonds.hpp"
#include "gpu/device_pores.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

// What a disc moves with, fetched early: each wait for memory counts.
struct DiscMotion {
  double inverse_mass, inverse_inertia, vx, vy, spin;
  __attribute__((always_inline)) DiscMotion(const KernelArrays& a, int64_t i)
      : inverse_mass(a.inverse_mass[i]),
        inverse_inertia(a.inverse_inertia[i]),
        vx(a.vx[i]),
        vy(a.vy[i]),
        spin(a.spin[i]) {}
};

// Disc i moves by the force f (x, y, moment); `at`: where it is. What damping takes comes to works[0], works[tile_size], ...
inline __attribute__((always_inline)) void move_disc(const KernelArrays& a, int64_t i, DiscMotion m,
                                                     const double* f, const double* at, double* works) {
  double ux = at[0], uy = at[1], rotation = at[2];
  works[0] = move(a.step, a.damping, f[0], m.inverse_mass, m.vx, ux);
  works[tile_size] = move(a.step, a.damping, f[1], m.inverse_mass, m.vy, uy);
  works[2 * tile_size] = move(a.step, a.damping, f[2], m.inverse_inertia, m.spin, rotation);
  a.vx[i] = m.vx;
  a.vy[i] = m.vy;
  a.spin[i] = m.spin;
  a.ux[i] = ux;
  a.uy[i] = uy;
  a.rotation[i] = rotation;
}

// Sums by lanes, each kind in a warp of its own: of a kind `lane` adds up every eighth value.
enum {
  lanes_of_sizes = 0,
  lanes_of_damping = 8,
  lanes_of_forces = 16,
  lanes_of_friction = 24,
  sums_so_far = 32
};

inline double sum_of_damping(const double* works, int32_t lane, int32_t discs) {
  constexpr int32_t chunk = 64;  // as kernels_body.hpp goes: x, y and rotation of so many discs
  double sum = 0.0;
  for (int32_t begin = 0; begin < discs; begin += chunk) {
    const int32_t end = begin + chunk < discs ? begin + chunk : discs;
    for (int32_t way = 0; way < 3; ++way)
      sum = sum_of_every(8, works + way * tile_size, begin + lane, end, sum);
  }
  return sum;
}

// What a disc gets from bonds of its tile.
struct TileBonds {
  double *fx, *fy, *moment_i, *minus_moment_j;
  __attribute__((always_inline)) void add(int32_t listed, double* f) const {
    const int32_t e = listed / 2;
    const bool is_first = listed % 2 == 0;
    f[0] = is_first ? f[0] + fx[e] : f[0] - fx[e];
    f[1] = is_first ? f[1] + fy[e] : f[1] - fy[e];
    f[2] = is_first ? f[2] + moment_i[e] : f[2] - minus_moment_j[e];
  }
  __attribute__((always_inline)) void add_all(const DeviceArrays& d, int64_t disc, const DeviceBonds& of,
                                              double* f) const {
    for (int32_t q = 0; q < disc_bonds; ++q) {
      const auto listed = static_cast<int32_t>((q < 4 ? of.first : of.second) >> (16 * (q % 4)) & 0xffff);
      if (listed != no_bond && listed != more_bonds) add(listed, f);
    }
    if ((of.second >> 48) != more_bonds) return;
    for (int32_t m = d.bond_start[disc] + disc_bonds - 1; m < d.bond_start[disc + 1]; ++m)
      add(d.bond_of[m], f);
  }
};

// What it gets from the tile's pores, at its corners.
inline __attribute__((always_inline)) void add_pores(const DeviceArrays& d, int32_t first, int32_t last,
                                                     int64_t first_domain, const double* pressures,
                                                     double* f) {
  constexpr int32_t at_once = 4;
  const KernelArrays& a = d.a;
  for (int32_t begin = first; begin < last; begin += at_once) {
    DeviceCorner corner[at_once];
    double x[at_once], y[at_once];
    for (int32_t q = 0; q < at_once; ++q) corner[q] = d.corner_of[begin + q < last ? begin + q : begin];
    for (int32_t q = 0; q < at_once; ++q) {
      x[q] = a.domain_corner_weight[2 * corner[q].corner];
      y[q] = a.domain_corner_weight[2 * corner[q].corner + 1];
    }
    for (int32_t q = 0; q < at_once; ++q) {
      if (begin + q >= last) continue;
      const double p = pressures[corner[q].domain - first_domain];
      f[0] += p * x[q];
      f[1] += p * y[q];
      f[2] += 0.0;  // a worker adds three forces at once
      if (a.domain_corner_turn == nullptr) continue;
      f[0] += 0.0;
      f[1] += 0.0;
      f[2] += p * a.domain_corner_turn[corner[q].corner];
    }
  }
}

// And from pores across tiles.
inline __attribute__((always_inline)) void add_pores_across(const KernelArrays& a, int32_t first,
                                                            int32_t last, double* f) {
  for (int32_t m = first; m < last; ++m) {
    const CrossCorner at = a.cross_corner[m];
    const double p = a.pressure[at.domain];
    f[0] += p * a.domain_corner_weight[2 * at.corner];
    f[1] += p * a.domain_corner_weight[2 * at.corner + 1];
    f[2] += a.domain_corner_turn != nullptr ? p * a.domain_corner_turn[at.corner] : 0.0;
  }
}

template <bool plain, class Block>
inline __attribute__((always_inline)) void step_tile(Block& block, const DeviceTask& t) {
  if (*t.d.stop < t.stage) return;
  const DeviceArrays& d = t.d;
  const KernelArrays& a = d.a;
  const int64_t number = item_of(t, block.number);
  const Tile tile = a.tiles[number];
  const int64_t first = tile.first_disc, first_bond = tile.first_bond, first_domain = tile.first_domain,
                first_block = tile.first_block;
  const auto discs = static_cast<int32_t>(tile.last_disc - first),
             bonds = static_cast<int32_t>(tile.last_bond - first_bond),
             domains = a.with_pressure != 0 ? static_cast<int32_t>(tile.last_domain - first_domain) : 0;
  // Displacements, later the works of the discs; sizes of forces; bonds: force, moments, friction; pores: works, pressures.
  double *motion = block.shared, *sizes = motion + 3 * tile_size, *fx = sizes + tile_size, *fy = fx + bonds,
         *moment_i = fy + bonds, *minus_moment_j = moment_i + bonds, *friction = minus_moment_j + bonds,
         *works = friction + bonds, *pressures = works + domains, *lanes = pressures + domains,
         *over = lanes + 40, *slid = over + 1;
  block.each(discs, [&](int64_t k) {
    const double ux = a.ux[first + k], uy = a.uy[first + k], rotation = a.rotation[first + k];
    motion[k] = ux;
    motion[tile_size + k] = uy;
    motion[2 * tile_size + k] = rotation;
    if (k == 0) *over = *slid = 0.0;
  });
  block.each(bonds + domains, [&](int64_t item) {
    const auto k = static_cast<int32_t>(item);
    if (k < bonds) {
      const int64_t e = first_bond + k;
      const auto i = static_cast<int32_t>(a.first[e] - first), j = static_cast<int32_t>(a.second[e] - first);
      const BondValues values(a, first_block, k);
      BondMotion m = bond_state<plain>(a, e);
      m.dux = motion[j] - motion[i];
      m.duy = motion[tile_size + j] - motion[tile_size + i];
      m.turn = motion[2 * tile_size + j] - motion[2 * tile_size + i];
      m.theta_i = motion[2 * tile_size + i];
      const BondAnswer r = take_bond<plain>(a, e, number, values.at, m);
      fx[k] = r.fx;
      fy[k] = r.fy;
      moment_i[k] = r.moment_i;
      minus_moment_j[k] = r.minus_moment_j;
      friction[k] = r.friction;
      if (r.over > 0.0) *over = 1.0;
      if (r.friction > 0.0) *slid = 1.0;
      return;
    }
    const int64_t domain = first_domain + k - bonds;
    works[k - bonds] = 0.0;
    double p = a.pressure[domain];
    if (a.undrained != 0) {
      const double change =
          change_of(a, a.domain_corner_start[domain], a.domain_corner_start[domain + 1], first, motion);
      works[k - bonds] = undrained_pressure(a, domain, change, p);
    }
    pressures[k - bonds] = p;
  });
  const bool moves = *over == 0.0 || t.moves_anyway != 0;
  const TileBonds forces{fx, fy, moment_i, minus_moment_j};
  block.each(t.looks_only == 0 ? discs : 0, [&](int64_t item) {
    const auto k = static_cast<int32_t>(item);
    const int64_t i = first + k;
    const DiscMotion disc(a, i);
    const DeviceBonds bonds_of = d.bonds_of[i];
    const int32_t first_slot = d.slot_start[i], last_slot = d.slot_start[i + 1],
                  first_cross = d.cross_start[i], last_cross = d.cross_start[i + 1],
                  first_corner = domains > 0 ? d.corner_start[i] : 0,
                  last_corner = domains > 0 ? d.corner_start[i + 1] : 0;
    hold(disc.inverse_mass);
    hold(disc.inverse_inertia);
    hold(disc.vx);
    hold(disc.vy);
    hold(disc.spin);
    double f[3] = {0.0, 0.0, 0.0};
    if (tile.left_alone == 0) {
      f[0] = a.external_x[i];
      f[1] = a.external_y[i];
      f[2] = a.external_moment[i];
    }
    // In the order in which a worker adds it; first what lies across tiles. (In a function of its own this costs registers.)
    constexpr int32_t at_once = 4;
    for (int32_t begin = first_slot; begin < last_slot; begin += at_once) {
      double x[at_once], y[at_once], moment[at_once];
      for (int32_t q = 0; q < at_once; ++q) {
        const BufferedForce& from = a.force_buffer[begin + q < last_slot ? begin + q : begin];
        x[q] = from.fx;
        y[q] = from.fy;
        moment[q] = from.moment;
      }
      for (int32_t q = 0; q < at_once; ++q) {
        if (begin + q >= last_slot) continue;
        f[0] += x[q];
        f[1] += y[q];
        f[2] += moment[q];
      }
    }
    add_pores_across(a, first_cross, last_cross, f);
    forces.add_all(d, i, bonds_of, f);
    add_pores(d, first_corner, last_corner, first_domain, pressures, f);
    if (!moves) {
      for (int32_t way = 0; way < 3; ++way) d.held_force[3 * i + way] = f[way];
      return;
    }
    sizes[k] = magnitude(f[0]) + magnitude(f[1]);
    const double at[3] = {motion[k], motion[tile_size + k], motion[2 * tile_size + k]};
    move_disc(a, i, disc, f, at, motion + k);
  });
  const bool moved = moves && t.looks_only == 0;
  block.each(6 * 32, [&](int64_t item) {
    const auto kind = static_cast<int32_t>(item / 32), lane = static_cast<int32_t>(item % 32);
    if (lane >= 8) return;
    double sum = 0.0;
    switch (kind) {
      case 0:
        if (moved && t.wants_forces != 0) sum = sum_of_every(8, sizes, lane, discs, 0.0);
        lanes[lanes_of_sizes + lane] = sum;
        break;
      case 1:
        if (moved) sum = sum_of_damping(motion, lane, discs);
        lanes[lanes_of_damping + lane] = sum;
        break;
      case 2:
        for (int32_t e = lane; t.wants_forces != 0 && e < bonds; e += 8) {
          const bool counts =
              plain || a.smooth.contacts == nullptr ||
              contact_of(a, first_bond + e, a.smooth.from[number], a.smooth.from[number + 1]) < 0;
          sum += counts ? magnitude(fx[e]) + magnitude(fy[e]) : 0.0;
        }
        lanes[lanes_of_forces + lane] = sum;
        break;
      case 3:
        if (*slid > 0.0) sum = sum_of_every(8, friction, lane, bonds, 0.0);
        lanes[lanes_of_friction + lane] = sum;
        break;
      case 4:
        if (lane == 0) lanes[sums_so_far] = a.bond_sums[number].work;
        if (lane == 1) lanes[sums_so_far + 1] = a.disc_sums[number].work;
        if (lane == 2 && a.with_pressure != 0) lanes[sums_so_far + 2] = a.domain_sums[number].work;
        break;
      default:
        if (lane == 0) lanes[sums_so_far + 3] = sum_of_every(1, works, 0, domains, 0.0);
    }
  });
  block.each(1, [&](int64_t) {
    TileSums &of_bonds = a.bond_sums[number], &of_discs = a.disc_sums[number];
    if (t.wants_forces != 0) of_bonds.force = total_of(lanes + lanes_of_forces);
    of_bonds.work = lanes[sums_so_far] + total_of(lanes + lanes_of_friction);
    of_bonds.flagged = *over > 0.0 ? 1 : 0;
    if (a.with_pressure != 0) a.domain_sums[number].work = lanes[sums_so_far + 2] + lanes[sums_so_far + 3];
    if (!moves && t.looks_only == 0) *d.stop = t.stage;
    if (!moved) return;
    if (t.wants_forces != 0) of_discs.force = total_of(lanes + lanes_of_sizes);
    of_discs.work = lanes[sums_so_far + 1] + total_of(lanes + lanes_of_damping);
  });
}

template <class Block>
void tile_step(Block& block, const DeviceTask& t) {
  step_tile<false>(block, t);
}

template <class Block>
void plain_tile_step(Block& block, const DeviceTask& t) {
  step_tile<true>(block, t);
}

template <class Block>
void tile_move(Block& block, const DeviceTask& t) {
  const KernelArrays& a = t.d.a;
  const int64_t number = item_of(t, block.number), first = a.tiles[number].first_disc;
  const auto discs = static_cast<int32_t>(a.tiles[number].last_disc - first);
  double *works = block.shared, *sizes = works + 3 * tile_size, *lanes = sizes + tile_size;
  block.each(discs, [&](int64_t k) {
    const int64_t i = first + k;
    const double f[3] = {t.d.held_force[3 * i], t.d.held_force[3 * i + 1], t.d.held_force[3 * i + 2]},
                 at[3] = {a.ux[i], a.uy[i], a.rotation[i]};
    sizes[k] = magnitude(f[0]) + magnitude(f[1]);
    move_disc(a, i, DiscMotion(a, i), f, at, works + k);
  });
  block.each(16, [&](int64_t k) {
    const auto lane = static_cast<int32_t>(k % 8);
    lanes[k] = k < 8 ? sum_of_every(8, sizes, lane, discs, 0.0) : sum_of_damping(works, lane, discs);
  });
  block.each(1, [&](int64_t) {
    TileSums& sums = a.disc_sums[number];
    if (t.wants_forces != 0) sums.force = total_of(lanes);
    sums.work += total_of(lanes + 8);
  });
}

}  // namespace
}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac
