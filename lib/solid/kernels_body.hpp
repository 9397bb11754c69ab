// SPDX-License-Identifier: BSD-3-Clause
// The body of the kernels, included once per instruction set with HFRAC_KERNEL_NAMESPACE set. See kernels.hpp.
//
// The bond law is written in total form: elastic forces follow from the displacements since bonding, so there is no
// history to drift and elastic energy is a function of state. With D the vector from disc i to disc j at bonding, d
// the vector now, L0 and L their lengths:
//   gap            g  = L - L0, as (2 D.du + du.du) / (L + L0): no cancellation
//   turn of d      phi = asin(D x d / (L0 L))
//   shear          u_s = L0 phi - (a_i theta_i + a_j theta_j)
//   bond           F_n = k_n g, F_s = k_s u_s, M = k_n (R^2 / 3) (theta_j - theta_i)     (eq. 16-20; I / A = R^2 / 3)
//   contact        F_n = -k_n max(0, -g), F_s = k_s (u_s - slip), |F_s| <= mu F_n
//   flat contact   springs along 2 R that bear pressure only: with a = R |theta_j - theta_i|, h = a - g and q = h / a < 2 (partly open)
//                  F_n = -k_n h q / 4, |M| = |F_n| R (1 - q / 3); as the bond's where all of it is pressed, q >= 2
//   forces on i    F_n n + F_s (L0 / L) t, moments F_s a_i + M and F_s a_j - M: the exact gradient of the energy
//   varied         g less what the discs grew, k and strengths times their factors, mu by bond (bond_factors.hpp)
//   breakage       F_n + 3 beta |M| / R >= sigma_c A  or  |F_s| >= tau_c A                (eq. 21-23, tension positive)
//   softening      tension, F_s and M of the bond times 1 - D from there on, and breakage at D = 1 (softening.hpp)
#include "solid/kernels_chunk.hpp"
#include "solid/kernels_smooth.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

// The law, for bonds e to e + n - 1, whose geometry begins with `block`, and what fills the last block up. With `varied`, bonds differ (bond_factors.hpp);
// with `flat`, contacts bear moments; with `softens`, which varies too, bonds soften.
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
  const double shear_per_normal = softens ? a.bond_shear / a.bond_normal : 0.0, energy = a.softening;
  const double bond_normal = a.bond_normal, bond_shear = a.bond_shear, contact_normal = a.contact_normal,
               contact_shear = a.contact_shear, friction = a.friction, bending_share = a.bending_share,
               contact_with_bond = a.contact_with_bond, tensile = a.tensile_capacity,
               shearing = a.shear_capacity;
  const double inverse_contact_shear = a.contact_shear > 0.0 ? 1.0 / a.contact_shear : 0.0;
  for (int64_t k = 0; k < n; ++k) c.intact[k] = static_cast<double>(intact_[k]);
  for (int64_t k = n; k < in_blocks(n); ++k) c.intact[k] = c.intact[n - 1];
  const auto one = [&](int64_t k, int64_t lane, const double* __restrict values)
      __attribute__((always_inline)) {
    const double dux = c.dux[k], duy = c.duy[k], turn = c.turn[k];
    const double dx = values[block_dx + lane], dy = values[block_dy + lane],
                 length = values[block_length + lane], arm_i = values[block_arm + lane],
                 arm_j = length - arm_i;
    const double lx = dx + dux, ly = dy + duy;
    const double now = __builtin_sqrt(lx * lx + ly * ly);
    // One division for 1 / L, 1 / (L + L0) and 1 / L0.
    const double both = now + length, at_once = 1.0 / (now * length * both);
    const double inverse = at_once * (length * both), inverse_length = at_once * (now * both);
    const double gap = (2.0 * (dx * dux + dy * duy) + (dux * dux + duy * duy)) * (at_once * (now * length)) -
                       (varied ? growth_[k] : 0.0);
    const double share = varied ? stiffness_[k] : 1.0;
    const double nx = lx * inverse, ny = ly * inverse;
    const double ratio = length * inverse;
    const double sine = (dx * duy - dy * dux) * inverse;  // times L0
    const double s = sine * inverse_length, s2 = s * s;
    const double shear = sine * (1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0 + s2 * (15.0 / 336.0)))) -
                         (length * c.theta_i[k] + arm_j * turn);

    const double intact = c.intact[k], radius = values[block_radius + lane];
    double bond_n = bond_normal * share * intact * gap;
    double bond_s = bond_shear * share * intact * shear;
    double bend = bond_normal * share * intact * radius * turn;  // 3 M / R
    if constexpr (softens) {
      constexpr double none = 1e-300;
      const double open = positive(gap);
      const double w = __builtin_sqrt(open * open + shear_per_normal * shear * shear +
                                      radius * radius * (1.0 / 3.0) * turn * turn);
      const double pulled = (bond_n + bending_share * magnitude(bend)) / (tensile * radius * tensile_[k]),
                   sheared = magnitude(bond_s) / (shearing * radius * shear_[k]);
      const double stress = pulled > sheared ? pulled : sheared;
      const double before = start_[k], begins = stress >= 1.0 ? w / (stress + none) : 0.0;
      const double start = before > 0.0 ? before : begins;
      const double soft = energy * radius / (bond_normal * share * start + none),
                   steep = steepest_softening * start + none, end = soft > steep ? soft : steep;
      const double farthest = w > worst_[k] ? w : worst_[k], reached = farthest < end ? farthest : end;
      const bool damaged = intact > 0.0 && start > 0.0;
      const double worst = damaged ? reached : worst_[k];
      const double kept = damaged && worst > start ? start * (end - worst) / (worst * (end - start)) : 1.0;
      bond_n *= gap > 0.0 ? kept : 1.0;
      bond_s *= kept;
      bend *= kept;
      c.start[k] = start;
      c.worst[k] = worst;
      c.over[k] = damaged && worst >= end ? 1.0 : 0.0;
    }

    const double present = intact > 0.0 ? contact_with_bond : 1.0;
    double squeeze = positive(-gap), contact_bend = 0.0;  // over stiffness
    if constexpr (flat) {
      const double edge = radius * magnitude(turn);
      const double deep = positive(edge - gap), part = deep / (edge + 1e-300);
      const bool whole = -gap >= edge;
      squeeze = whole ? -gap : 0.25 * deep * part;
      contact_bend = whole ? edge : squeeze * (3.0 - part);
      contact_bend = turn < 0.0 ? -contact_bend : contact_bend;
    }
    const double contact_n = contact_normal * share * present * squeeze;
    const double moment =
        (flat ? bend + contact_normal * share * present * contact_bend : bend) * radius * (1.0 / 3.0);
    const double limit = (varied ? friction_[k] : friction) * contact_n;
    const double slip = slip_[k];
    const double trial = contact_shear * share * (shear - slip);
    // In the order of operands in which one instruction each does it.
    const double below = limit < trial ? limit : trial, contact_s = -limit > below ? -limit : below;
    const double slipped =
        magnitude(trial) > limit ? shear - contact_s * (inverse_contact_shear / share) : slip;
    c.friction[k] = magnitude(contact_s * (slipped - slip));
    c.slip[k] = slipped;

    const double normal = bond_n - contact_n, tangential = bond_s + contact_s;
    const double across = tangential * ratio;
    const double fx = normal * nx - across * ny;
    const double fy = normal * ny + across * nx;
    c.fx[k] = fx;
    c.fy[k] = fy;
    c.moment_i[k] = tangential * arm_i + moment;
    c.minus_moment_j[k] = moment - tangential * arm_j;
    c.force[k] = magnitude(fx) + magnitude(fy);

    // Excess over strength, as a number so that the loop stays in vector registers; a broken bond has none.
    const double pull =
        bond_n + bending_share * magnitude(bend) - tensile * radius * (varied ? tensile_[k] : 1.0);
    const double push = magnitude(bond_s) - shearing * radius * (varied ? shear_[k] : 1.0);
    const double excess = pull > push ? pull : push;
    if constexpr (!softens) c.over[k] = intact > 0.0 && excess >= 0.0 ? 1.0 : 0.0;
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

// Pressure of a domain whose volume has changed by `change`; adds the work it did on the way.
inline double undrained_pressure(const KernelArrays& a, int64_t d, double change, double& work) {
  const double before = a.pressure[d];
  double p = before;
  if (a.stiffness[d] > 0.0) {
    p = a.reference_pressure + a.stiffness[d] * (a.content[d] - change);
    p = p > a.floor_pressure ? p : a.floor_pressure;  // cavitation
  }
  work += 0.5 * (before + p) * (change - a.volume_change[d]);
  a.pressure[d] = p;
  a.volume_change[d] = change;
  return p;
}

// turns: whether turning discs change volumes, too (domain_corner_turn is there). Asked once a tile, not once a domain.
template <bool turns>
double tile_domains(const KernelArrays& a, const Tile& t, const Quad* motion, Quad* force) {
  double work = 0.0;
  for (int64_t d = t.first_domain; d < t.last_domain; ++d) {
    const int32_t begin = a.domain_corner_start[d], end = a.domain_corner_start[d + 1];
    double p = a.pressure[d];
    if (a.undrained != 0) {
      double change = 0.0;
      for (int32_t k = begin; k < end; ++k) {
        const Quad& u = motion[a.domain_corner_disc[k] - t.first_disc];
        change += a.domain_corner_weight[2 * k] * u[0] + a.domain_corner_weight[2 * k + 1] * u[1];
      }
      if constexpr (turns) {
        for (int32_t k = begin; k < end; ++k)
          change += a.domain_corner_turn[k] * motion[a.domain_corner_disc[k] - t.first_disc][2];
      }
      p = undrained_pressure(a, d, change, work);
    }
    for (int32_t k = begin; k < end; ++k) {
      const Quad push = {p * a.domain_corner_weight[2 * k], p * a.domain_corner_weight[2 * k + 1], 0.0, 0.0};
      force[a.domain_corner_disc[k] - t.first_disc] += push;
    }
    if constexpr (turns) {
      for (int32_t k = begin; k < end; ++k)
        force[a.domain_corner_disc[k] - t.first_disc] += Quad{0.0, 0.0, p * a.domain_corner_turn[k], 0.0};
    }
  }
  return work;
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

template <bool turns>
void cross_domains_with(const KernelArrays& a, int64_t part) {
  double work = 0.0;
  for (int64_t q = a.cross_parts[part].first_domain; q < a.cross_parts[part].last_domain; ++q) {
    const int64_t d = a.cross_domain[q];
    const int32_t first = a.domain_corner_start[d], last = a.domain_corner_start[d + 1];
    double p = a.pressure[d];
    if (a.undrained != 0) {
      double change = 0.0;
      for (int32_t k = first; k < last; ++k) {
        const int32_t disc = a.domain_corner_disc[k];
        change += a.domain_corner_weight[2 * k] * a.ux[disc] + a.domain_corner_weight[2 * k + 1] * a.uy[disc];
        if constexpr (turns) change += a.domain_corner_turn[k] * a.rotation[disc];
      }
      p = undrained_pressure(a, d, change, work);
    }
    const int32_t* place = a.corner_slot + a.cross_corner_start[q];
    for (int32_t k = first; k < last; ++k) {
      if (place[k - first] < 0) continue;
      BufferedForce& to = a.force_buffer[place[k - first]];
      to.fx = p * a.domain_corner_weight[2 * k];
      to.fy = p * a.domain_corner_weight[2 * k + 1];
      if constexpr (turns) to.moment = p * a.domain_corner_turn[k];
    }
  }
  a.domain_sums[a.tile_count + part].work += work;
}

void cross_domains(const KernelArrays& a, int64_t part) {
  (a.domain_corner_turn == nullptr ? cross_domains_with<false> : cross_domains_with<true>)(a, part);
}

// One degree of freedom of some discs: leap-frog with local damping (Cundall 1987). Adds up the damping work.
void integrate(int64_t n, double step, double damping, const double* __restrict force,
               const double* __restrict inverse_mass, double* __restrict velocity,
               double* __restrict displacement, Partial& sum) {
  double work[chunk];
  for (int64_t k = 0; k < n; ++k) {
    const double f = force[k], v = velocity[k];
    const double against = v > 0.0 ? 1.0 : (v < 0.0 ? -1.0 : 0.0);
    const double drag = damping * magnitude(f) * against;
    const double after = v + step * (f - drag) * inverse_mass[k];
    work[k] = 0.5 * step * drag * (v + after);
    velocity[k] = after;
    displacement[k] += step * after;
  }
  add_up(sum, work, n);
}

void tile_move(const KernelArrays& a, int64_t tile, const double* scratch) {
  const Tile& t = a.tiles[tile];
  const Quad* force = reinterpret_cast<const Quad*>(scratch) + tile_size;
  Partial unbalanced{}, damped{};
  for (int64_t first = t.first_disc; first < t.last_disc; first += chunk) {
    const int64_t n = first + chunk < t.last_disc ? chunk : t.last_disc - first;
    alignas(32) double fx[chunk], fy[chunk], moment[chunk], size[chunk];
    // A chunk of records is whole in the scratch memory even where the tile ends.
    for (int64_t k = 0; k < n; k += 4) {
      const Quad* f = force + (first - t.first_disc + k);
      Quad f0 = f[0], f1 = f[1], f2 = f[2], f3 = f[3];
      transpose(f0, f1, f2, f3);
      *reinterpret_cast<Quad*>(fx + k) = f0;
      *reinterpret_cast<Quad*>(fy + k) = f1;
      *reinterpret_cast<Quad*>(moment + k) = f2;
    }
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
