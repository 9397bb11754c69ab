// SPDX-License-Identifier: BSD-3-Clause
// The step loop on a device, as blocks of threads: one source, compiled to PTX for a card and to a loop over threads for tests without one.
//
// A kernel is a row of parallel loops, `block.each(n, f)`: f(0) to f(n - 1) by whichever threads, in any order, and all of them before what
// follows. What one tile's discs and bonds need of each other goes through the block's own memory, `block.shared`. Laws are those of
// solid/kernels_law.hpp and sums are made in the order of solid/kernels_body.hpp, so results are the processor's to the last bit.
//
// A cycle is two stages: bonds and pores across tiles with boundary and non-bonded contacts; then tiles. A bond that exceeds its strength ends the
// batch with its stage: what comes later returns at once, the host breaks bonds and goes on from there (solid/device_cycles.cpp).
#pragma once

#include "solid/device_arrays.hpp"
#include "solid/kernels_law.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

// Of values[from], values[from + every] ... up to `to`, one after the other; eight are fetched at once.
inline __attribute__((always_inline)) double sum_of_every(int32_t every, const double* values, int32_t from,
                                                          int32_t to, double sum) {
  constexpr int32_t at_once = 8;
  int32_t k = from;
  for (; k + (at_once - 1) * every < to; k += at_once * every) {
    double next[at_once];
    for (int32_t q = 0; q < at_once; ++q) next[q] = values[k + q * every];
    for (const double value : next) sum += value;
  }
  for (; k < to; k += every) sum += values[k];
  return sum;
}

// Has `value` at hand from here on: the compiler would fetch it where it is used, and all threads would wait once more.
inline __attribute__((always_inline)) void hold([[maybe_unused]] double value) {
#ifdef __CUDA__
  asm volatile("" ::"d"(value));
#endif
}

struct OneLane {
  using Value = double;
};

inline int64_t item_of(const DeviceTask& t, int64_t block) {
  return t.list != nullptr ? t.list[block] : block;
}

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
    double pressure = a.pressure[d];
    t.d.large_works[place] = a.undrained != 0 ? undrained_pressure(a, d, *sum, pressure) : 0.0;
    *sum = pressure;
  });
  const int32_t* slots = a.corner_slot + a.cross_corner_start[place];
  block.each(last - first, [&](int64_t c) {
    if (slots[c] < 0) return;
    const int64_t k = first + c;
    BufferedForce& to = a.force_buffer[slots[c]];
    to.fx = *sum * a.domain_corner_weight[2 * k];
    to.fy = *sum * a.domain_corner_weight[2 * k + 1];
    if (turns) to.moment = *sum * a.domain_corner_turn[k];
  });
}

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
    const int32_t* place = a.corner_slot + a.cross_corner_start[p.first_domain + q];
    if (last - first > most_corners) {
      works[q] = t.d.large_works[p.first_domain + q];
      return;
    }
    double pressure = a.pressure[d];
    works[q] = 0.0;
    if (a.undrained != 0) {
      double change = 0.0;
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
    }
    for (int32_t begin = first; begin < last; begin += at_once) {
      int32_t slot[at_once];
      double x[at_once], y[at_once], turn[at_once];
      for (int32_t c = 0; c < at_once; ++c) {
        const int32_t k = begin + c < last ? begin + c : begin;
        slot[c] = place[k - first];
        x[c] = a.domain_corner_weight[2 * k];
        y[c] = a.domain_corner_weight[2 * k + 1];
        turn[c] = turns ? a.domain_corner_turn[k] : 0.0;
      }
      for (int32_t c = 0; c < at_once; ++c) {
        if (begin + c >= last || slot[c] < 0) continue;
        BufferedForce& to = a.force_buffer[slot[c]];
        to.fx = pressure * x[c];
        to.fy = pressure * y[c];
        if (turns) to.moment = pressure * turn[c];
      }
    }
  });
  block.each(1, [&](int64_t) {
    a.domain_sums[a.tile_count + part].work +=
        sum_of_every(1, works, 0, static_cast<int32_t>(p.last_domain - p.first_domain), 0.0);
  });
}

// Boundary::cycle: what walls do to their discs, wall by wall on a disc in a corner, which two press.
template <class Block>
void press_walls(Block& block, const DeviceTask& t) {
  if (*t.d.stop < t.stage) return;
  const DeviceArrays& d = t.d;
  const KernelArrays& a = d.a;
  block.each(device_threads, [&](int64_t k) {
    const int64_t at = block.number * device_threads + k;
    if (at >= d.wall_disc_count) return;
    const DeviceWallDisc disc = d.wall_discs[at];
    const double ux = a.ux[disc.disc], uy = a.uy[disc.disc];
    double fx = 0.0, fy = 0.0;
    for (int side = 0; side < 2 && disc.wall[side] >= 0; ++side) {
      const DeviceWall& wall = d.outside->walls[disc.wall[side]];
      const double closing = wall.displacement - (ux * wall.inward_x + uy * wall.inward_y) + disc.growth;
      const double force = d.wall_stiffness * positive(closing);
      d.wall_force[disc.place[side]] = force;
      fx += force * wall.inward_x;
      fy += force * wall.inward_y;
    }
    d.external_x[disc.disc] = fx;
    d.external_y[disc.disc] = fy;
  });
}

// Likewise: the motion of walls under servo control.
template <class Block>
void move_walls(Block& block, const DeviceTask& t) {
  const DeviceArrays& d = t.d;
  double* push = block.shared;
  block.each(4 * 32, [&](int64_t k) {
    if (k % 32 != 0) return;  // each in a warp of its own
    const DeviceWall& wall = d.outside->walls[k / 32];
    push[k / 32] =
        sum_of_every(1, d.wall_force, static_cast<int32_t>(wall.first), static_cast<int32_t>(wall.last), 0.0);
  });
  block.each(1, [&](int64_t) {
    d.outside->imbalance = 0.0;
    for (int w = 0; w < 4; ++w) {
      DeviceWall& wall = d.outside->walls[w];
      if (wall.first == wall.last) continue;
      const double force = wall.target - push[w];
      const double least = magnitude(wall.target) < wall.floor ? wall.floor : magnitude(wall.target);
      const double share = magnitude(force) / least;
      d.outside->imbalance = d.outside->imbalance < share ? share : d.outside->imbalance;
      const double drag =
          d.a.damping * magnitude(force) * (wall.velocity > 0.0 ? 1.0 : (wall.velocity < 0.0 ? -1.0 : 0.0));
      wall.velocity += d.a.step * (force - drag) / wall.mass;
      wall.displacement += d.a.step * wall.velocity;
      d.outside->work += wall.target * d.a.step * wall.velocity;
    }
  });
}

// NonBondedContacts::cycle: contacts first, then every disc collects its own.
template <class Block>
void press_contacts(Block& block, const DeviceTask& t) {
  const DeviceArrays& d = t.d;
  const KernelArrays& a = d.a;
  block.each(d.contact_count, [&](int64_t k) {
    DevicePair& pair = d.pairs[k];
    const int32_t i = pair.first, j = pair.second;
    const double dx = (d.x[j] + a.ux[j]) - (d.x[i] + a.ux[i]), dy = (d.y[j] + a.uy[j]) - (d.y[i] + a.uy[i]);
    const double distance = __builtin_sqrt(dx * dx + dy * dy);
    const double gap =
        distance - d.radius[i] - d.radius[j] - pair.reference_gap - pair.growth_first - pair.growth_second;
    pair.touches = gap < 0.0 ? 1 : 0;
    if (gap >= 0.0) {
      pair.shear_force = pair.normal_force = 0.0;
      return;
    }
    const double inverse = 1.0 / distance;
    const double nx = inverse * dx, ny = inverse * dy, tx = -ny, ty = nx;
    const double share = distance / (d.radius[i] + d.radius[j]), arm_i = share * d.radius[i],
                 arm_j = share * d.radius[j];
    const double speed = (a.vx[j] - a.vx[i]) * tx + (a.vy[j] - a.vy[i]) * ty;
    const double slide = a.step * (speed - a.spin[i] * arm_i - a.spin[j] * arm_j);
    pair.normal_force = -pair.normal * gap;
    const double limit = pair.friction * pair.normal_force;
    const double trial = pair.shear_force + pair.shear * slide;
    pair.shear_force = trial < -limit ? -limit : (limit < trial ? limit : trial);
    pair.friction_work =
        pair.shear > 0.0 ? magnitude(pair.shear_force * (trial - pair.shear_force)) / pair.shear : 0.0;
    pair.on_first_x = -pair.normal_force * nx + pair.shear_force * tx;
    pair.on_first_y = -pair.normal_force * ny + pair.shear_force * ty;
    pair.arm_first = arm_i;
    pair.arm_second = arm_j;
  });
  block.each(d.pushed_count + 1, [&](int64_t k) {
    if (k == d.pushed_count) {
      for (int64_t p = 0; p < d.contact_count; ++p) {
        if (d.pairs[p].touches != 0) d.outside->friction += d.pairs[p].friction_work;
      }
      return;
    }
    const DevicePushedDisc& disc = d.pushed[k];
    double fx = disc.keeps_load != 0 ? d.external_x[disc.disc] : disc.load_x,
           fy = disc.keeps_load != 0 ? d.external_y[disc.disc] : disc.load_y, moment = 0.0;
    for (int64_t q = disc.first; q < disc.last; ++q) {
      const DevicePair& pair = d.pairs[d.pushed_pairs[q] / 2];
      if (pair.touches == 0) continue;
      const bool first = d.pushed_pairs[q] % 2 == 0;
      fx = first ? fx + pair.on_first_x : fx - pair.on_first_x;
      fy = first ? fy + pair.on_first_y : fy - pair.on_first_y;
      moment += pair.shear_force * (first ? pair.arm_first : pair.arm_second);
    }
    d.external_x[disc.disc] = fx;
    d.external_y[disc.disc] = fy;
    d.external_moment[disc.disc] = moment;
  });
}

template <class Block>
void push(Block& block, const DeviceTask& t) {
  if (*t.d.stop < t.stage) return;
  if (t.d.walled != 0 && t.d.servo != 0) move_walls(block, t);
  if (t.d.pushed_count > 0) press_contacts(block, t);
}

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

// Corners from `from` up to `to` of pore `domain`: by how much its volume has changed. `motion`: of the tile's discs.
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
  // What a disc gets, in the order in which a worker adds it.
  block.each(t.looks_only == 0 ? discs : 0, [&](int64_t item) {
    const auto k = static_cast<int32_t>(item);
    const int64_t i = first + k;
    const DiscMotion disc(a, i);
    const DeviceBonds bonds_of = d.bonds_of[i];
    const int32_t first_slot = d.slot_start[i], last_slot = d.slot_start[i + 1],
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
    const auto add_bond = [&](int32_t listed) {
      const int32_t e = listed / 2;
      const bool is_first = listed % 2 == 0;
      f[0] = is_first ? f[0] + fx[e] : f[0] - fx[e];
      f[1] = is_first ? f[1] + fy[e] : f[1] - fy[e];
      f[2] = is_first ? f[2] + moment_i[e] : f[2] - minus_moment_j[e];
    };
    for (int32_t q = 0; q < disc_bonds; ++q) {
      const auto listed =
          static_cast<int32_t>((q < 4 ? bonds_of.first : bonds_of.second) >> (16 * (q % 4)) & 0xffff);
      if (listed != no_bond && listed != more_bonds) add_bond(listed);
    }
    if ((bonds_of.second >> 48) == more_bonds) {
      for (int32_t m = d.bond_start[i] + disc_bonds - 1; m < d.bond_start[i + 1]; ++m) add_bond(d.bond_of[m]);
    }
    for (int32_t begin = first_corner; begin < last_corner; begin += at_once) {
      DeviceCorner corner[at_once];
      double x[at_once], y[at_once];
      for (int32_t q = 0; q < at_once; ++q)
        corner[q] = d.corner_of[begin + q < last_corner ? begin + q : begin];
      for (int32_t q = 0; q < at_once; ++q) {
        x[q] = a.domain_corner_weight[2 * corner[q].corner];
        y[q] = a.domain_corner_weight[2 * corner[q].corner + 1];
      }
      for (int32_t q = 0; q < at_once; ++q) {
        if (begin + q >= last_corner) continue;
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
