// SPDX-License-Identifier: BSD-3-Clause
// Pores on a device that answer and push, by the volume of their corners: those across tiles, and how a pore of one tile changes.
#pragma once

#include "gpu/device_sums.hpp"
#include "solid/kernels_law.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

// A pore of many corners, around a well: all threads of a block, then one that adds up.
template <class Block>
void large_pores(Block& block, const DeviceTask& t) {
  if (*t.d.stop < t.stage) return;
  const KernelArrays& a = t.d.a;
  const int64_t place = t.d.large_pores[block.number], d = a.cross_domain[place];
  const int32_t first = a.domain_corner_start[d], last = a.domain_corner_start[d + 1];
  const bool turns = a.domain_corner_turn != nullptr;
  constexpr int32_t at_once = 1024;
  double *terms = block.shared, *sum = terms + 2 * at_once;
  for (int32_t begin = first; begin < last && a.undrained != 0; begin += at_once) {
    const int32_t n = begin + at_once < last ? at_once : last - begin, each = turns ? 2 : 1;
    block.each(n, [&](int64_t c) {
      const int64_t k = begin + c, disc = a.domain_corner_disc[k];
      terms[each * c] =
          a.domain_corner_weight[2 * k] * a.ux[disc] + a.domain_corner_weight[2 * k + 1] * a.uy[disc];
      if (turns) terms[2 * c + 1] = a.domain_corner_turn[k] * a.rotation[disc];
    });
    block.each(1, [&](int64_t) { *sum = sum_of_every(1, terms, 0, each * n, begin == first ? 0.0 : *sum); });
  }
  block.each(1, [&](int64_t) {
    double pressure = 0.0;
    t.d.large_works[place] = a.undrained != 0 ? undrained_pressure(a, d, *sum, pressure) : 0.0;
  });
}

// Pores that belong to a tile and reach into others; those of many corners are done, and their works are added here.
template <class Block>
void cross_pores(Block& block, const DeviceTask& t) {
  if (*t.d.stop < t.stage) return;
  const KernelArrays& a = t.d.a;
  const int64_t part = item_of(t, block.number);
  const CrossPart p = a.cross_parts[part];
  const bool turns = a.domain_corner_turn != nullptr;
  constexpr int32_t at_once = 4;  // corners, fetched before they are used
  double* works = block.shared;
  block.each(p.last_domain - p.first_domain, [&](int64_t q) {
    const int64_t d = a.cross_domain[p.first_domain + q];
    const int32_t first = a.domain_corner_start[d], last = a.domain_corner_start[d + 1];
    if (last - first > most_corners) {
      works[q] = t.d.large_works[p.first_domain + q];
      return;
    }
    works[q] = 0.0;
    if (a.undrained == 0) return;
    double pressure = 0.0, change = 0.0;
    for (int32_t begin = first; begin < last; begin += at_once) {
      double x[at_once], turn[at_once];
      for (int32_t c = 0; c < at_once; ++c) {
        const int32_t k = begin + c < last ? begin + c : begin, disc = a.domain_corner_disc[k];
        x[c] = a.domain_corner_weight[2 * k] * a.ux[disc] + a.domain_corner_weight[2 * k + 1] * a.uy[disc];
        turn[c] = turns ? a.domain_corner_turn[k] * a.rotation[disc] : 0.0;
      }
      for (int32_t c = 0; c < at_once; ++c) {
        if (begin + c >= last) continue;
        change += x[c];
        if (turns) change += turn[c];
      }
    }
    works[q] = undrained_pressure(a, d, change, pressure);
  });
  block.each(1, [&](int64_t) {
    a.domain_sums[a.tile_count + part].work +=
        sum_of_every(1, works, 0, static_cast<int32_t>(p.last_domain - p.first_domain), 0.0);
  });
}

// By how much a pore's volume has changed, by its corners from `from` up to `to`. `motion`: of the tile's discs.
inline __attribute__((always_inline)) double change_of(const KernelArrays& a, int32_t from, int32_t to,
                                                       int64_t first_disc, const double* motion) {
  constexpr int32_t at_once = 4;
  double change = 0.0;
  for (int32_t begin = from; begin < to; begin += at_once) {
    int32_t disc[at_once];
    double x[at_once], y[at_once];
    for (int32_t q = 0; q < at_once; ++q) {
      const int32_t c = begin + q < to ? begin + q : from;
      disc[q] = static_cast<int32_t>(a.domain_corner_disc[c] - first_disc);
      x[q] = a.domain_corner_weight[2 * c];
      y[q] = a.domain_corner_weight[2 * c + 1];
    }
    for (int32_t q = 0; q < at_once; ++q)
      if (begin + q < to) change += x[q] * motion[disc[q]] + y[q] * motion[tile_size + disc[q]];
  }
  for (int32_t c = from; a.domain_corner_turn != nullptr && c < to; ++c)
    change += a.domain_corner_turn[c] * motion[2 * tile_size + a.domain_corner_disc[c] - first_disc];
  return change;
}

}  // namespace
}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac
