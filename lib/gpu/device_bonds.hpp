// SPDX-License-Identifier: BSD-3-Clause
// Bonds on a device: the answer of one, for every kind of rock, and those between two tiles, whose forces go through the force buffer.
#pragma once

#include "gpu/device_sums.hpp"
#include "solid/kernels_law.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

struct OneLane {
  using Value = double;
};

// `plain`: no bond softens, no contact is flat or of a smooth joint. Such rock has kernels of its own, which need half the registers.
template <bool plain>
inline __attribute__((always_inline)) BondMotion bond_state(const KernelArrays& a, int64_t e) {
  BondMotion m;
  m.intact = static_cast<double>(a.intact[e]);
  m.slip = a.slip[e];
  if (a.tensile_factor != nullptr) {
    m.growth = a.growth[e];
    m.stiffness = a.stiffness_factor[e];
    m.tensile = a.tensile_factor[e];
    m.shear = a.shear_factor[e];
    m.friction = a.bond_friction[e];
  }
  if (!plain && a.softening_start != nullptr) {
    m.start = a.softening_start[e];
    m.worst = a.softening_worst[e];
  }
  return m;
}

template <bool plain>
inline __attribute__((always_inline)) BondAnswer answer_any(const KernelArrays& a, const double* values,
                                                            const BondMotion& m) {
  const BondConstants law(a);
  if constexpr (plain)
    return a.tensile_factor != nullptr ? answer_bond<true, false, false>(law, values, m)
                                       : answer_bond<false, false, false>(law, values, m);
  const bool flat = a.flat != 0;
  if (a.softening_start != nullptr)
    return flat ? answer_bond<true, true, true>(law, values, m)
                : answer_bond<true, false, true>(law, values, m);
  if (a.tensile_factor != nullptr)
    return flat ? answer_bond<true, true, false>(law, values, m)
                : answer_bond<true, false, false>(law, values, m);
  return flat ? answer_bond<false, true, false>(law, values, m)
              : answer_bond<false, false, false>(law, values, m);
}

// The contact of a smooth joint that stands for bond e, among those from `from` up to `to`; -1: none does.
inline int64_t contact_of(const KernelArrays& a, int64_t e, int64_t from, int64_t to) {
  const ContactRecord* contacts = static_cast<const ContactRecord*>(a.smooth.contacts);
  while (from < to) {
    const int64_t middle = (from + to) / 2;
    if (contacts[middle].bond < e)
      from = middle + 1;
    else
      to = middle;
  }
  return from < a.smooth.count && contacts[from].bond == e ? from : -1;
}

inline __attribute__((always_inline)) void answer_in_place(const KernelArrays& a, int64_t contact,
                                                           const BondMotion& m, BondAnswer& r) {
  const ContactRecord& c = static_cast<const ContactRecord*>(a.smooth.contacts)[contact];
  const double* settled = a.smooth.settled != nullptr ? a.smooth.settled + 4 * contact : nullptr;
  const auto settled_at = [settled](int64_t k) { return settled != nullptr ? settled[k] : 0.0; };
  const ContactAnswer<OneLane> s =
      answer_contact<OneLane>({c.normal_x, c.normal_y, c.area, c.opens_i, c.opens_j, c.slides_i, c.slides_j,
                               settled_at(0), settled_at(1), settled_at(2), settled_at(3)},
                              ContactLaw<OneLane>(a.smooth.laws[a.smooth.law_number[c.joint]]),
                              {m.dux, m.duy, m.theta_i, m.turn, m.slip, m.intact});
  r.fx = s.fx;
  r.fy = s.fy;
  r.moment_i = s.moment_i;
  r.minus_moment_j = s.minus_moment_j;
  r.slip = s.slip;
  r.friction = s.friction;
  r.over = s.over;
  r.force = 0.0;
}

// Bond e with its motion filled in: what it answers, and its slip and softening kept. `values`: of its geometry.
template <bool plain>
inline __attribute__((always_inline)) BondAnswer take_bond(const KernelArrays& a, int64_t e, int64_t part,
                                                           const double* values, const BondMotion& m) {
  BondAnswer r = answer_any<plain>(a, values, m);
  if (!plain && a.softening_start != nullptr) {
    a.softening_start[e] = r.start;
    a.softening_worst[e] = r.worst;
  }
  if (!plain && a.smooth.contacts != nullptr) {
    const int64_t contact = contact_of(a, e, a.smooth.from[part], a.smooth.from[part + 1]);
    if (contact >= 0) answer_in_place(a, contact, m, r);
  }
  a.slip[e] = r.slip;
  return r;
}

// A bond's geometry, as the law reads it. Fetched with all else that a bond needs: each wait for memory counts.
struct BondValues {
  double at[block_values];
  __attribute__((always_inline)) BondValues(const KernelArrays& a, int64_t first_block, int64_t behind) {
    const double* from =
        a.geometry + (first_block + behind / block_bonds) * block_values + behind % block_bonds;
    at[block_dx] = from[block_dx];
    at[block_dy] = from[block_dy];
    at[block_length] = from[block_length];
    at[block_arm] = from[block_arm];
    at[block_radius] = from[block_radius];
  }
};

template <bool plain, class Block>
inline __attribute__((always_inline)) void answer_pair(Block& block, const DeviceTask& t) {
  if (*t.d.stop < t.stage) return;
  const KernelArrays& a = t.d.a;
  const int64_t pair = item_of(t, block.number);
  const TilePair& p = a.pairs[pair];
  constexpr int64_t at_once = 64;
  double *force = block.shared, *friction = force + at_once, *over = friction + at_once,
         *lanes = over + at_once;
  for (int64_t begin = p.first_bond; begin < p.last_bond; begin += at_once) {
    const auto n = static_cast<int32_t>(begin + at_once < p.last_bond ? at_once : p.last_bond - begin);
    block.each(n, [&](int64_t k) {
      const int64_t e = begin + k;
      const int32_t i = a.first[e], j = a.second[e];
      const int32_t* place = a.bond_slot + 2 * (e - a.first_cross_bond);
      const int32_t place_i = place[0], place_j = place[1];
      const BondValues values(a, p.first_block, e - p.first_bond);
      BondMotion m = bond_state<plain>(a, e);
      m.dux = a.ux[j] - a.ux[i];
      m.duy = a.uy[j] - a.uy[i];
      m.turn = a.rotation[j] - a.rotation[i];
      m.theta_i = a.rotation[i];
      const BondAnswer r = take_bond<plain>(a, e, a.tile_count + pair, values.at, m);
      BufferedForce &to_i = a.force_buffer[place_i], &to_j = a.force_buffer[place_j];
      to_i.fx = r.fx;
      to_i.fy = r.fy;
      to_i.moment = r.moment_i;
      to_j.fx = -r.fx;
      to_j.fy = -r.fy;
      to_j.moment = -r.minus_moment_j;
      force[k] = r.force;
      friction[k] = r.friction;
      over[k] = r.over;
    });
    block.each(18, [&](int64_t lane) {
      if (lane == 17) {
        lanes[17] = a.bond_sums[a.tile_count + pair].work;
        return;
      }
      double sum = begin == p.first_bond ? 0.0 : lanes[lane];
      if (lane == 16)
        sum = sum_of_every(1, over, 0, n, sum);
      else
        sum = sum_of_every(8, lane < 8 ? force : friction, static_cast<int32_t>(lane % 8), n, sum);
      lanes[lane] = sum;
    });
  }
  block.each(1, [&](int64_t) {
    TileSums& sums = a.bond_sums[a.tile_count + pair];
    sums.force = total_of(lanes);
    sums.work = lanes[17] + total_of(lanes + 8);
    sums.flagged = lanes[16] > 0.0 ? 1 : 0;
    if (sums.flagged != 0) *t.d.stop = t.stage;
  });
}

template <class Block>
void cross_pairs(Block& block, const DeviceTask& t) {
  answer_pair<false>(block, t);
}

template <class Block>
void plain_cross_pairs(Block& block, const DeviceTask& t) {
  answer_pair<true>(block, t);
}

}  // namespace
}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac
