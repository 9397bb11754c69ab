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

struct OneLane {
  using Value = double;
};

inline int64_t item_of(const DeviceTask& t, int64_t block) {
  return t.list != nullptr ? t.list[block] : block;
}

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
  if (a.softening_start != nullptr) {
    m.start = a.softening_start[e];
    m.worst = a.softening_worst[e];
  }
  return m;
}

inline __attribute__((always_inline)) BondAnswer answer_any(const KernelArrays& a, const double* values,
                                                            const BondMotion& m) {
  const BondConstants law(a);
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
inline __attribute__((always_inline)) BondAnswer take_bond(const KernelArrays& a, int64_t e, int64_t part,
                                                           const double* values, const BondMotion& m) {
  BondAnswer r = answer_any(a, values, m);
  if (a.softening_start != nullptr) {
    a.softening_start[e] = r.start;
    a.softening_worst[e] = r.worst;
  }
  if (a.smooth.contacts != nullptr) {
    const int64_t contact = contact_of(a, e, a.smooth.from[part], a.smooth.from[part + 1]);
    if (contact >= 0) answer_in_place(a, contact, m, r);
  }
  a.slip[e] = r.slip;
  return r;
}

inline const double* values_of(const KernelArrays& a, int64_t first_block, int64_t behind) {
  return a.geometry + (first_block + behind / block_bonds) * block_values + behind % block_bonds;
}

template <class Block>
void cross_pairs(Block& block, const DeviceTask& t) {
  if (*t.d.stop < t.stage) return;
  const KernelArrays& a = t.d.a;
  const int64_t pair = item_of(t, block.number);
  const TilePair& p = a.pairs[pair];
  constexpr int64_t at_once = 64;
  double *force = block.shared, *friction = force + at_once, *lanes = friction + at_once;
  double* over = lanes + 16;
  block.each(17, [&](int64_t k) { lanes[k] = 0.0; });
  for (int64_t begin = p.first_bond; begin < p.last_bond; begin += at_once) {
    const int64_t n = begin + at_once < p.last_bond ? at_once : p.last_bond - begin;
    block.each(n, [&](int64_t k) {
      const int64_t e = begin + k;
      const int32_t i = a.first[e], j = a.second[e];
      BondMotion m = bond_state(a, e);
      m.dux = a.ux[j] - a.ux[i];
      m.duy = a.uy[j] - a.uy[i];
      m.turn = a.rotation[j] - a.rotation[i];
      m.theta_i = a.rotation[i];
      const BondAnswer r =
          take_bond(a, e, a.tile_count + pair, values_of(a, p.first_block, e - p.first_bond), m);
      const int32_t* place = a.bond_slot + 2 * (e - a.first_cross_bond);
      BufferedForce &to_i = a.force_buffer[place[0]], &to_j = a.force_buffer[place[1]];
      to_i.fx = r.fx;
      to_i.fy = r.fy;
      to_i.moment = r.moment_i;
      to_j.fx = -r.fx;
      to_j.fy = -r.fy;
      to_j.moment = -r.minus_moment_j;
      force[k] = r.force;
      friction[k] = r.friction;
      if (r.over > 0.0) *over = 1.0;
    });
    block.each(16, [&](int64_t lane) {
      const double* values = lane < 8 ? force : friction;
      for (int64_t k = lane % 8; k < n; k += 8) lanes[lane] += values[k];
    });
  }
  block.each(1, [&](int64_t) {
    TileSums& sums = a.bond_sums[a.tile_count + pair];
    sums.force = total_of(lanes);
    sums.work += total_of(lanes + 8);
    sums.flagged = *over > 0.0 ? 1 : 0;
    if (sums.flagged != 0) *t.d.stop = t.stage;
  });
}

template <class Block>
void cross_pores(Block& block, const DeviceTask& t) {
  if (*t.d.stop < t.stage) return;
  const KernelArrays& a = t.d.a;
  const int64_t part = item_of(t, block.number);
  const CrossPart& p = a.cross_parts[part];
  const bool turns = a.domain_corner_turn != nullptr;
  double* works = block.shared;
  block.each(p.last_domain - p.first_domain, [&](int64_t q) {
    const int64_t d = a.cross_domain[p.first_domain + q];
    const int32_t first = a.domain_corner_start[d], last = a.domain_corner_start[d + 1];
    double pressure = a.pressure[d];
    works[q] = 0.0;
    if (a.undrained != 0) {
      double change = 0.0;
      for (int32_t k = first; k < last; ++k) {
        const int32_t disc = a.domain_corner_disc[k];
        change += a.domain_corner_weight[2 * k] * a.ux[disc] + a.domain_corner_weight[2 * k + 1] * a.uy[disc];
        if (turns) change += a.domain_corner_turn[k] * a.rotation[disc];
      }
      works[q] = undrained_pressure(a, d, change, pressure);
    }
    const int32_t* place = a.corner_slot + a.cross_corner_start[p.first_domain + q];
    for (int32_t k = first; k < last; ++k) {
      if (place[k - first] < 0) continue;
      BufferedForce& to = a.force_buffer[place[k - first]];
      to.fx = pressure * a.domain_corner_weight[2 * k];
      to.fy = pressure * a.domain_corner_weight[2 * k + 1];
      if (turns) to.moment = pressure * a.domain_corner_turn[k];
    }
  });
  block.each(1, [&](int64_t) {
    double work = 0.0;
    for (int64_t q = 0; q < p.last_domain - p.first_domain; ++q) work += works[q];
    a.domain_sums[a.tile_count + part].work += work;
  });
}

// Boundary::cycle: what walls do to their discs, and the motion of those under servo control.
template <class Block>
void press_walls(Block& block, const DeviceTask& t) {
  const DeviceArrays& d = t.d;
  const KernelArrays& a = d.a;
  block.each(d.wall_disc_count, [&](int64_t k) {
    d.external_x[d.wall_discs[k].disc] = d.external_y[d.wall_discs[k].disc] = 0.0;
  });
  // Wall by wall, since a disc in a corner is pressed by two.
  for (int w = 0; w < 4; ++w) {
    const DeviceWall& wall = d.outside->walls[w];
    block.each(wall.last - wall.first, [&](int64_t q) {
      const int64_t k = wall.first + q;
      const int64_t i = d.wall_discs[k].disc;
      const double closing =
          wall.displacement - (a.ux[i] * wall.inward_x + a.uy[i] * wall.inward_y) + d.wall_discs[k].growth;
      const double force = d.wall_stiffness * positive(closing);
      d.wall_force[k] = force;
      d.external_x[i] += force * wall.inward_x;
      d.external_y[i] += force * wall.inward_y;
    });
  }
  double* push = block.shared;
  block.each(4, [&](int64_t w) {
    push[w] = 0.0;
    for (int64_t k = d.outside->walls[w].first; k < d.outside->walls[w].last; ++k) push[w] += d.wall_force[k];
  });
  block.each(1, [&](int64_t) {
    d.outside->imbalance = 0.0;
    for (int w = 0; w < 4; ++w) {
      DeviceWall& wall = d.outside->walls[w];
      if (d.servo == 0 || wall.first == wall.last) continue;
      const double force = wall.target - push[w];
      const double least = magnitude(wall.target) < wall.floor ? wall.floor : magnitude(wall.target);
      const double share = magnitude(force) / least;
      d.outside->imbalance = d.outside->imbalance < share ? share : d.outside->imbalance;
      const double drag =
          a.damping * magnitude(force) * (wall.velocity > 0.0 ? 1.0 : (wall.velocity < 0.0 ? -1.0 : 0.0));
      wall.velocity += a.step * (force - drag) / wall.mass;
      wall.displacement += a.step * wall.velocity;
      d.outside->work += wall.target * a.step * wall.velocity;
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
  if (t.d.walled != 0) press_walls(block, t);
  if (t.d.pushed_count > 0) press_contacts(block, t);
}

// The tile's discs move by `force` (x, y, moment of each); their sums.
template <class Block, class Force>
void move_discs(Block& block, const DeviceTask& t, int64_t tile, double* works, double* sizes, double* lanes,
                const Force& force) {
  const KernelArrays& a = t.d.a;
  const int64_t first = a.tiles[tile].first_disc, discs = a.tiles[tile].last_disc - first;
  block.each(discs, [&](int64_t k) {
    double f[3];
    force(k, f);
    const int64_t i = first + k;
    sizes[k] = magnitude(f[0]) + magnitude(f[1]);
    works[k] = move(a.step, a.damping, f[0], a.inverse_mass[i], a.vx[i], a.ux[i]);
    works[tile_size + k] = move(a.step, a.damping, f[1], a.inverse_mass[i], a.vy[i], a.uy[i]);
    works[2 * tile_size + k] = move(a.step, a.damping, f[2], a.inverse_inertia[i], a.spin[i], a.rotation[i]);
  });
  constexpr int64_t chunk = 64;  // as kernels_body.hpp goes: x, y and rotation of so many discs
  block.each(16, [&](int64_t lane) {
    double sum = 0.0;
    for (int64_t k = lane; lane < 8 && k < discs; k += 8) sum += sizes[k];
    for (int64_t begin = 0; lane >= 8 && begin < discs; begin += chunk) {
      const int64_t end = begin + chunk < discs ? begin + chunk : discs;
      for (int64_t way = 0; way < 3; ++way) {
        for (int64_t k = begin + lane % 8; k < end; k += 8) sum += works[way * tile_size + k];
      }
    }
    lanes[lane] = sum;
  });
  block.each(1, [&](int64_t) {
    a.disc_sums[tile].force = total_of(lanes);
    a.disc_sums[tile].work += total_of(lanes + 8);
  });
}

template <class Block>
void tile_step(Block& block, const DeviceTask& t) {
  if (*t.d.stop < t.stage) return;
  const DeviceArrays& d = t.d;
  const KernelArrays& a = d.a;
  const int64_t number = item_of(t, block.number);
  const Tile& tile = a.tiles[number];
  const int64_t first = tile.first_disc, discs = tile.last_disc - first,
                bonds = tile.last_bond - tile.first_bond,
                domains = a.with_pressure != 0 ? tile.last_domain - tile.first_domain : 0;
  // Displacements, later the works of the discs; sizes of forces; bonds: force and moments, sums; pores: works.
  double *motion = block.shared, *sizes = motion + 3 * tile_size, *fx = sizes + tile_size, *fy = fx + bonds,
         *moment_i = fy + bonds, *minus_moment_j = moment_i + bonds, *force = minus_moment_j + bonds,
         *friction = force + bonds, *works = friction + bonds, *lanes = works + domains, *over = lanes + 16;
  block.each(discs, [&](int64_t k) {
    motion[k] = a.ux[first + k];
    motion[tile_size + k] = a.uy[first + k];
    motion[2 * tile_size + k] = a.rotation[first + k];
    if (k == 0) *over = 0.0;
  });
  block.each(bonds + domains, [&](int64_t k) {
    if (k < bonds) {
      const int64_t e = tile.first_bond + k, i = a.first[e] - first, j = a.second[e] - first;
      BondMotion m = bond_state(a, e);
      m.dux = motion[j] - motion[i];
      m.duy = motion[tile_size + j] - motion[tile_size + i];
      m.turn = motion[2 * tile_size + j] - motion[2 * tile_size + i];
      m.theta_i = motion[2 * tile_size + i];
      const BondAnswer r = take_bond(a, e, number, values_of(a, tile.first_block, k), m);
      fx[k] = r.fx;
      fy[k] = r.fy;
      moment_i[k] = r.moment_i;
      minus_moment_j[k] = r.minus_moment_j;
      force[k] = r.force;
      friction[k] = r.friction;
      if (r.over > 0.0) *over = 1.0;
      return;
    }
    const int64_t domain = tile.first_domain + k - bonds;
    works[k - bonds] = 0.0;
    if (a.undrained == 0) return;
    const int32_t begin = a.domain_corner_start[domain], end = a.domain_corner_start[domain + 1];
    double change = 0.0, p = 0.0;
    for (int32_t c = begin; c < end; ++c) {
      const int64_t i = a.domain_corner_disc[c] - first;
      change += a.domain_corner_weight[2 * c] * motion[i] +
                a.domain_corner_weight[2 * c + 1] * motion[tile_size + i];
    }
    for (int32_t c = begin; a.domain_corner_turn != nullptr && c < end; ++c)
      change += a.domain_corner_turn[c] * motion[2 * tile_size + a.domain_corner_disc[c] - first];
    works[k - bonds] = undrained_pressure(a, domain, change, p);
  });
  // What a disc gets, in the order in which a worker adds it.
  const auto collect = [&](int64_t k, double* f) {
    const int64_t i = first + k;
    f[0] = f[1] = f[2] = 0.0;
    if (tile.left_alone == 0) {
      f[0] = a.external_x[i];
      f[1] = a.external_y[i];
      f[2] = a.external_moment[i];
    }
    for (int32_t m = d.slot_start[i]; m < d.slot_start[i + 1]; ++m) {
      f[0] += a.force_buffer[m].fx;
      f[1] += a.force_buffer[m].fy;
      f[2] += a.force_buffer[m].moment;
    }
    for (int32_t m = d.bond_start[i]; m < d.bond_start[i + 1]; ++m) {
      const int64_t e = d.bond_of[m] / 2;
      const bool is_first = d.bond_of[m] % 2 == 0;
      f[0] = is_first ? f[0] + fx[e] : f[0] - fx[e];
      f[1] = is_first ? f[1] + fy[e] : f[1] - fy[e];
      f[2] = is_first ? f[2] + moment_i[e] : f[2] - minus_moment_j[e];
    }
    if (domains == 0) return;
    for (int32_t m = d.corner_start[i]; m < d.corner_start[i + 1]; ++m) {
      const int32_t c = d.corner_of[m].corner;
      const double p = a.pressure[d.corner_of[m].domain];
      f[0] += p * a.domain_corner_weight[2 * c];
      f[1] += p * a.domain_corner_weight[2 * c + 1];
      f[2] += 0.0;  // a worker adds three forces at once
      if (a.domain_corner_turn == nullptr) continue;
      f[0] += 0.0;
      f[1] += 0.0;
      f[2] += p * a.domain_corner_turn[c];
    }
  };
  const bool waits = *over > 0.0 && t.moves_anyway == 0 && t.looks_only == 0;
  block.each(17, [&](int64_t lane) {
    if (lane == 16) {
      double work = 0.0;
      for (int64_t k = 0; k < domains; ++k) work += works[k];
      if (a.with_pressure != 0) a.domain_sums[number].work += work;
      return;
    }
    const double* values = lane < 8 ? force : friction;
    double sum = 0.0;
    for (int64_t k = lane % 8; k < bonds; k += 8) sum += values[k];
    lanes[lane] = sum;
  });
  block.each(1, [&](int64_t) {
    TileSums& sums = a.bond_sums[number];
    sums.force = total_of(lanes);
    sums.work += total_of(lanes + 8);
    sums.flagged = *over > 0.0 ? 1 : 0;
    if (waits) *d.stop = t.stage;
  });
  if (t.looks_only != 0) return;
  if (!waits) {
    move_discs(block, t, number, motion, sizes, lanes, collect);
    return;
  }
  block.each(discs, [&](int64_t k) { collect(k, d.held_force + 3 * (first + k)); });
}

template <class Block>
void tile_move(Block& block, const DeviceTask& t) {
  const int64_t tile = item_of(t, block.number), first = t.d.a.tiles[tile].first_disc;
  double *works = block.shared, *sizes = works + 3 * tile_size, *lanes = sizes + tile_size;
  move_discs(block, t, tile, works, sizes, lanes, [&](int64_t k, double* f) {
    for (int64_t way = 0; way < 3; ++way) f[way] = t.d.held_force[3 * (first + k) + way];
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

// The sums that a batch of cycles adds to, from 0.
template <class Block>
void clear_sums(Block& block, const DeviceTask& t) {
  const KernelArrays& a = t.d.a;
  const int64_t tiles = a.tile_count, first = block.number * device_threads;
  block.each(device_threads, [&](int64_t k) {
    const int64_t at = first + k;
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
