// SPDX-License-Identifier: BSD-3-Clause
// What a device does between cycles: rigid motion and its removal, sums that begin anew, and a look at all it holds.
#pragma once

#include "gpu/device_sums.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

// Boundary::momenta.
template <class Block>
void momenta(Block& block, const DeviceTask& t) {
  const DeviceArrays& d = t.d;
  const KernelArrays& a = d.a;
  const int64_t tile = item_of(t, block.number), first = a.tiles[tile].first_disc,
                discs = a.tiles[tile].last_disc - first;
  double* of = block.shared;
  block.each(discs, [&](int64_t k) {
    const int64_t i = first + k;
    const double m = d.mass[i], rx = d.x[i] - d.centre_x, ry = d.y[i] - d.centre_y;
    of[k] = m * a.ux[i];
    of[tile_size + k] = m * a.uy[i];
    of[2 * tile_size + k] = m * (rx * a.uy[i] - ry * a.ux[i]);
    of[3 * tile_size + k] = m * a.vx[i];
    of[4 * tile_size + k] = m * a.vy[i];
    of[5 * tile_size + k] = m * (rx * a.vy[i] - ry * a.vx[i]);
  });
  block.each(6, [&](int64_t way) {
    double sum = 0.0;
    for (int64_t k = 0; k < discs; ++k) sum += of[way * tile_size + k];
    d.momenta[6 * tile + way] = sum;
  });
}

// Boundary::take_out.
template <class Block>
void take_out(Block& block, const DeviceTask& t) {
  const DeviceArrays& d = t.d;
  const KernelArrays& a = d.a;
  const int64_t tile = item_of(t, block.number), first = a.tiles[tile].first_disc;
  block.each(a.tiles[tile].last_disc - first, [&](int64_t k) {
    const int64_t i = first + k;
    const double rx = d.x[i] - d.centre_x, ry = d.y[i] - d.centre_y;
    a.ux[i] -= t.motion[0] - t.motion[2] * ry;
    a.uy[i] -= t.motion[1] + t.motion[2] * rx;
    a.rotation[i] -= t.motion[2];
    a.vx[i] -= t.motion[3] - t.motion[5] * ry;
    a.vy[i] -= t.motion[4] + t.motion[5] * rx;
    a.spin[i] -= t.motion[5];
  });
}

// The sums that a batch of cycles adds to, from 0; nothing has stopped it.
template <class Block>
void clear_sums(Block& block, const DeviceTask& t) {
  const KernelArrays& a = t.d.a;
  const int64_t tiles = a.tile_count, first = block.number * device_threads;
  block.each(device_threads, [&](int64_t k) {
    const int64_t at = first + k;
    if (at == 0) *t.d.stop = never_stopped;
    if (at < tiles + a.pair_count) a.bond_sums[at] = {};
    if (at < tiles) a.disc_sums[at] = {};
    if (at < 2 * tiles) a.domain_sums[at] = {};
  });
}

// What a tile's discs, and a share of all bonds, hold: motion energy, and whether all of it is a number.
template <class Block>
void look_over(Block& block, const DeviceTask& t) {
  const DeviceArrays& d = t.d;
  const KernelArrays& a = d.a;
  const int64_t tile = block.number, first = a.tiles[tile].first_disc,
                discs = a.tiles[tile].last_disc - first;
  double *energy = block.shared, *off = energy + tile_size;
  const auto is_number = [](double value) { return value - value == 0.0; };
  block.each(tile_size, [&](int64_t k) {
    energy[k] = 0.0;
    if (k == 0) *off = 0.0;
  });
  block.each(discs, [&](int64_t k) {
    const int64_t i = first + k;
    energy[k] = 0.5 * (a.vx[i] * a.vx[i] + a.vy[i] * a.vy[i]) / a.inverse_mass[i];
    if (a.inverse_inertia[i] > 0.0) energy[k] += 0.5 * a.spin[i] * a.spin[i] / a.inverse_inertia[i];
    if (!is_number(energy[k]) || !is_number(a.rotation[i]) || !is_number(d.external_x[i]) ||
        !is_number(d.external_y[i]) || !is_number(d.external_moment[i]))
      *off = 1.0;
  });
  const int64_t share = (a.bond_count + a.tile_count - 1) / a.tile_count, from = tile * share,
                to = from + share < a.bond_count ? from + share : a.bond_count;
  block.each(to - from, [&](int64_t k) {
    const int64_t e = from + k;
    bool good = is_number(a.slip[e]);
    if (a.softening_start != nullptr)
      good = good && is_number(a.softening_start[e]) && is_number(a.softening_worst[e]);
    if (!good) *off = 1.0;
  });
  for (int64_t half = tile_size / 2; half > 0; half /= 2)
    block.each(half, [&](int64_t k) { energy[k] += energy[k + half]; });
  block.each(1, [&](int64_t) {
    d.looked[2 * tile] = energy[0];
    d.looked[2 * tile + 1] = *off;
  });
}

}  // namespace
}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac
