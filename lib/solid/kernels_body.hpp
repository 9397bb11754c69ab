// SPDX-License-Identifier: BSD-3-Clause
// The body of the kernels, included once per instruction set with HFRAC_KERNEL_NAMESPACE set. See kernels.hpp.
#include "solid/kernels_chunk.hpp"
#include "solid/kernels_pores.hpp"
#include "solid/kernels_smooth.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

// The law, for bonds e to e + n - 1, whose geometry begins with `block`, and what fills the last block up.
template <bool varied, bool flat, bool softens>
__attribute__((noinline)) void bond_law_with(const KernelArrays& a, int64_t e, int64_t n,
                                             const double* __restrict block, Chunk& c) {
  constexpr int64_t most = softens ? 8 : varied ? 6 : 1;
  double copies[most][chunk];
  const uint8_t* __restrict intact_ = a.intact + e;
  const double* __restrict slip_ = whole_blocks(a.slip + e, n, copies[0]);
  const double* __restrict growth_ =
      varied ? whole_blocks(a.growth + e, n, copies[most > 1 ? 1 : 0]) : nullptr;
  const double* __restrict stiffness_ =
      varied ? whole_blocks(a.stiffness_factor + e, n, copies[most > 1 ? 2 : 0]) : nullptr;
  const double* __restrict tensile_ =
      varied ? whole_blocks(a.tensile_factor + e, n, copies[most > 1 ? 3 : 0]) : nullptr;
  const double* __restrict shear_ =
      varied ? whole_blocks(a.shear_factor + e, n, copies[most > 1 ? 4 : 0]) : nullptr;
  const double* __restrict friction_ =
      varied ? whole_blocks(a.bond_friction + e, n, copies[most > 1 ? 5 : 0]) : nullptr;
  const double* __restrict start_ =
      softens ? whole_blocks(a.softening_start + e, n, copies[most > 6 ? 6 : 0]) : nullptr;
  const double* __restrict worst_ =
      softens ? whole_blocks(a.softening_worst + e, n, copies[most > 6 ? 7 : 0]) : nullptr;
  const BondConstants law(a);
  for (int64_t k = 0; k < n; ++k) c.intact[k] = static_cast<double>(intact_[k]);
  for (int64_t k = n; k < in_blocks(n); ++k) c.intact[k] = c.intact[n - 1];
  const auto one = [&](int64_t k, int64_t lane, const double* __restrict values)
      __attribute__((always_inline)) {
    BondMotion m;
    m.dux = c.dux[k];
    m.duy = c.duy[k];
    m.turn = c.turn[k];
    m.theta_i = c.theta_i[k];
    m.intact = c.intact[k];
    m.slip = slip_[k];
    if constexpr (varied) {
      m.growth = growth_[k];
      m.stiffness = stiffness_[k];
      m.tensile = tensile_[k];
      m.shear = shear_[k];
      m.friction = friction_[k];
    }
    if constexpr (softens) {
      m.start = start_[k];
      m.worst = worst_[k];
    }
    const BondAnswer r = answer_bond<varied, flat, softens>(law, values + lane, m);
    c.fx[k] = r.fx;
    c.fy[k] = r.fy;
    c.moment_i[k] = r.moment_i;
    c.minus_moment_j[k] = r.minus_moment_j;
    c.force[k] = r.force;
    c.friction[k] = r.friction;
    c.over[k] = r.over;
    c.slip[k] = r.slip;
    if constexpr (softens) {
      c.start[k] = r.start;
      c.worst[k] = r.worst;
    }
  };
  for (int64_t begin = 0; begin < n; begin += block_bonds, block += block_values) {
    // What the next chunk's block here will hold: bit by bit, since memory takes only so many requests at a time.
    for (int64_t line = 0; line < block_values; line += 64 / static_cast<int64_t>(sizeof(double)))
      __builtin_prefetch(block + chunk / block_bonds * block_values + line);
#pragma GCC ivdep
#pragma GCC unroll 1
    for (int64_t lane = 0; lane < block_bonds; ++lane) one(begin + lane, lane, block);
  }
}

// The geometry of bond e is that of value `at` on.
inline void bond_law(const KernelArrays& a, int64_t e, int64_t n, int64_t at, Chunk& c) {
  const bool flat = a.flat != 0;
  if (a.softening_start != nullptr) {
    (flat ? bond_law_with<true, true, true> : bond_law_with<true, false, true>)(a, e, n, a.geometry + at, c);
  } else if (a.tensile_factor != nullptr) {
    (flat ? bond_law_with<true, true, false> : bond_law_with<true, false, false>)(a, e, n, a.geometry + at,
                                                                                  c);
  } else {
    (flat ? bond_law_with<false, true, false> : bond_law_with<false, false, false>)(a, e, n, a.geometry + at,
                                                                                    c);
  }
}

struct BondSums {
  Partial force{}, friction{}, over{};
  void add(const Chunk& c, int64_t n) {
    add_up(force, c.force, n);
    add_up(friction, c.friction, n);
    add_up(over, c.over, n);
  }
  void put(TileSums& sums) const {
    sums.force = total(force);
    sums.work += total(friction);
    sums.flagged = total(over) > 0.0 ? 1 : 0;
  }
};

// Apart, so that rock whose bonds do not soften has one test more.
__attribute__((noinline)) void keep_softening(const KernelArrays& a, int64_t e, int64_t n, const Chunk& c) {
  for (int64_t k = 0; k < n; ++k) {
    a.softening_start[e + k] = c.start[k];
    a.softening_worst[e + k] = c.worst[k];
  }
}

void keep_slip(const KernelArrays& a, int64_t e, int64_t n, const Chunk& c) {
  double* __restrict to = a.slip + e;
  for (int64_t k = 0; k < n; ++k) to[k] = c.slip[k];
  if (a.softening_start != nullptr) keep_softening(a, e, n, c);
}

// Asks for what else the chunk of bonds from e on will read.
inline void fetch_bonds(const KernelArrays& a, int64_t e) {
  constexpr int64_t line = 8;
  for (int64_t k = e; k < e + chunk; k += line) __builtin_prefetch(a.slip + k, 1);
  for (int64_t k = e; k < e + chunk; k += 2 * line) {
    __builtin_prefetch(a.first + k);
    __builtin_prefetch(a.second + k);
  }
  __builtin_prefetch(a.intact + e);
}

// Where the geometry of a chunk begins that is so many bonds behind the first of its part.
inline int64_t geometry_at(int64_t first_block, int64_t behind) {
  return (first_block + behind / block_bonds) * block_values;
}

void tile_forces(const KernelArrays& a, int64_t tile, double* scratch) {
  const Tile& t = a.tiles[tile];
  const int64_t discs = t.last_disc - t.first_disc;
  Quad* motion = reinterpret_cast<Quad*>(scratch);
  Quad* force = motion + tile_size;
  // To be written, too: where another worker read them, asking for the lines one at a time, in tile_move, would stop it each time.
  for (int64_t k = t.first_disc; k < t.last_disc; k += 8) {
    __builtin_prefetch(a.ux + k, 1);
    __builtin_prefetch(a.uy + k, 1);
    __builtin_prefetch(a.rotation + k, 1);
  }
  to_records(a.ux + t.first_disc, a.uy + t.first_disc, a.rotation + t.first_disc, discs, motion);
  if (t.left_alone != 0) {
    for (int64_t k = 0; k < discs; ++k) force[k] = Quad{0.0, 0.0, 0.0, 0.0};
  } else {
    to_records(a.external_x + t.first_disc, a.external_y + t.first_disc, a.external_moment + t.first_disc,
               discs, force);
  }
  for (int64_t m = t.first_slot; m < t.last_slot; ++m) {
    const BufferedForce& entry = a.force_buffer[m];
    force[entry.disc - t.first_disc] += Quad{entry.fx, entry.fy, entry.moment, 0.0};
  }
  push_across(a, t, force);
  Chunk c;
  BondSums sums;
  int64_t contact = a.smooth.contacts != nullptr ? a.smooth.from[tile] : 0;
  for (int64_t e = t.first_bond; e < t.last_bond; e += chunk) {
    const int64_t n = e + chunk < t.last_bond ? chunk : t.last_bond - e;
    fetch_bonds(a, e + chunk);
    gather(a.first + e, a.second + e, t.first_disc, motion, n, c);
    bond_law(a, e, n, geometry_at(t.first_block, e - t.first_bond), c);
    if (a.smooth.contacts != nullptr) contact = answer_smooth(a, e, n, contact, c);
    keep_slip(a, e, n, c);
    sums.add(c, n);
    scatter(a.first + e, a.second + e, t.first_disc, force, n, c);
  }
  sums.put(a.bond_sums[tile]);
  if (a.with_pressure != 0) {
    a.domain_sums[tile].work += a.domain_corner_turn == nullptr ? tile_domains<false>(a, t, motion, force)
                                                                : tile_domains<true>(a, t, motion, force);
  }
}

// The same from the arrays of all discs, for bonds that know no tile.
void gather_anywhere(const KernelArrays& a, int64_t e, int64_t n, Chunk& c) {
  for (int64_t k = 0; k < in_blocks(n); ++k) {
    const int64_t bond = e + (k < n ? k : n - 1);
    const int32_t i = a.first[bond], j = a.second[bond];
    c.dux[k] = a.ux[j] - a.ux[i];
    c.duy[k] = a.uy[j] - a.uy[i];
    c.turn[k] = a.rotation[j] - a.rotation[i];
    c.theta_i[k] = a.rotation[i];
  }
}

void cross_bonds(const KernelArrays& a, int64_t pair) {
  const TilePair& p = a.pairs[pair];
  Chunk c;
  BondSums sums;
  int64_t contact = a.smooth.contacts != nullptr ? a.smooth.from[a.tile_count + pair] : 0;
  for (int64_t e = p.first_bond; e < p.last_bond; e += chunk) {
    const int64_t n = e + chunk < p.last_bond ? chunk : p.last_bond - e;
    gather_anywhere(a, e, n, c);
    bond_law(a, e, n, geometry_at(p.first_block, e - p.first_bond), c);
    if (a.smooth.contacts != nullptr) contact = answer_smooth(a, e, n, contact, c);
    keep_slip(a, e, n, c);
    sums.add(c, n);
    const int32_t* place = a.bond_slot + 2 * (e - a.first_cross_bond);
    for (int64_t k = 0; k < n; ++k) {
      BufferedForce& to_i = a.force_buffer[place[2 * k]];
      BufferedForce& to_j = a.force_buffer[place[2 * k + 1]];
      to_i.fx = c.fx[k];
      to_i.fy = c.fy[k];
      to_i.moment = c.moment_i[k];
      to_j.fx = -c.fx[k];
      to_j.fy = -c.fy[k];
      to_j.moment = -c.minus_moment_j[k];
    }
  }
  sums.put(a.bond_sums[a.tile_count + pair]);
}

void cross_domains(const KernelArrays& a, int64_t part) {
  (a.domain_corner_turn == nullptr ? cross_domains_with<false> : cross_domains_with<true>)(a, part);
}

// One degree of freedom of some discs. Adds up the damping work.
void integrate(int64_t n, double step, double damping, const double* __restrict force,
               const double* __restrict inverse_mass, double* __restrict velocity,
               double* __restrict displacement, Partial& sum) {
  double work[chunk];
  for (int64_t k = 0; k < n; ++k) {
    work[k] = move(step, damping, force[k], inverse_mass[k], velocity[k], displacement[k]);
  }
  add_up(sum, work, n);
}

void tile_move(const KernelArrays& a, int64_t tile, const double* scratch) {
  const Tile& t = a.tiles[tile];
  const Quad* force = reinterpret_cast<const Quad*>(scratch) + tile_size;
  Partial unbalanced{}, damped{};
  for (int64_t first = t.first_disc; first < t.last_disc; first += chunk) {
    const int64_t n = first + chunk < t.last_disc ? chunk : t.last_disc - first;
    alignas(64) double fx[chunk], fy[chunk], moment[chunk], size[chunk];
    // A chunk of records is whole in the scratch memory even where the tile ends.
    from_records(force + (first - t.first_disc), n, fx, fy, moment);
    for (int64_t k = 0; k < n; ++k) size[k] = magnitude(fx[k]) + magnitude(fy[k]);
    add_up(unbalanced, size, n);
    integrate(n, a.step, a.damping, fx, a.inverse_mass + first, a.vx + first, a.ux + first, damped);
    integrate(n, a.step, a.damping, fy, a.inverse_mass + first, a.vy + first, a.uy + first, damped);
    integrate(n, a.step, a.damping, moment, a.inverse_inertia + first, a.spin + first, a.rotation + first,
              damped);
  }
  a.disc_sums[tile].force = total(unbalanced);
  a.disc_sums[tile].work += total(damped);
}

void forces_of_part(const KernelArrays& a, int64_t first, int64_t last, int64_t first_block, int64_t& contact,
                    BondForce* to) {
  Chunk c;
  for (int64_t e = first; e < last; e += chunk) {
    const int64_t n = e + chunk < last ? chunk : last - e;
    gather_anywhere(a, e, n, c);
    bond_law(a, e, n, geometry_at(first_block, e - first), c);
    if (a.smooth.contacts != nullptr) contact = answer_smooth(a, e, n, contact, c);
    for (int64_t k = 0; k < n; ++k)
      to[e + k] = BondForce{c.fx[k], c.fy[k], c.moment_i[k], -c.minus_moment_j[k]};
  }
}

void bond_forces(const KernelArrays& a, BondForce* to) {
  int64_t contact = 0;
  for (int64_t t = 0; t < a.tile_count; ++t)
    forces_of_part(a, a.tiles[t].first_bond, a.tiles[t].last_bond, a.tiles[t].first_block, contact, to);
  for (int64_t p = 0; p < a.pair_count; ++p)
    forces_of_part(a, a.pairs[p].first_bond, a.pairs[p].last_bond, a.pairs[p].first_block, contact, to);
}

}  // namespace

extern const KernelTable table;
const KernelTable table = {tile_forces,   tile_move,   cross_bonds,
                           cross_domains, bond_forces, HFRAC_KERNEL_NAME};

}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac
