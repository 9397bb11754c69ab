// SPDX-License-Identifier: BSD-3-Clause
// The laws of one bond, one pore and one disc, as the kernels of every instruction set and those of a device run them.
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
#pragma once

#include "solid/kernels.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

inline __attribute__((always_inline)) double positive(double a) {
  return a > 0.0 ? a : 0.0;
}
inline __attribute__((always_inline)) double magnitude(double a) {
  return __builtin_fabs(a);
}

// Eight partial sums come to this.
inline double total_of(const double* lane) {
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

// A contact of a smooth joint as it lies in memory (model/smooth_contacts.hpp).
struct ContactRecord {
  int32_t bond, joint;
  double normal_x, normal_y, area, opens_i, opens_j, slides_i, slides_j;
};

// What all bonds have in common (KernelArrays).
struct BondConstants {
  double bond_normal, bond_shear, contact_normal, contact_shear, inverse_contact_shear, friction,
      bending_share, contact_with_bond, tensile, shearing, shear_per_normal, softening;
  explicit __attribute__((always_inline)) BondConstants(const KernelArrays& a)
      : bond_normal(a.bond_normal),
        bond_shear(a.bond_shear),
        contact_normal(a.contact_normal),
        contact_shear(a.contact_shear),
        inverse_contact_shear(a.contact_shear > 0.0 ? 1.0 / a.contact_shear : 0.0),
        friction(a.friction),
        bending_share(a.bending_share),
        contact_with_bond(a.contact_with_bond),
        tensile(a.tensile_capacity),
        shearing(a.shear_capacity),
        shear_per_normal(a.softening_start != nullptr ? a.bond_shear / a.bond_normal : 0.0),
        softening(a.softening) {}
};

// What a bond answers to. The last two lines are read where rock varies and where bonds soften only.
struct BondMotion {
  double dux, duy, turn, theta_i;  // m, m, rad, rad: second disc less first; first disc
  double intact, slip;             // 1 or 0; m
  double growth, stiffness, tensile, shear, friction;
  double start, worst;
};

struct BondAnswer {
  double fx, fy, moment_i, minus_moment_j;
  double force, friction, over;  // for the sums; over: 1 if it is to break
  double slip, start, worst;     // after this cycle
};

// With `varied`, bonds differ; with `flat`, contacts bear moments; with `softens`, which varies too, bonds soften. `values` is where the
// bond's first value lies in its block (core/layout.hpp).
template <bool varied, bool flat, bool softens>
inline __attribute__((always_inline)) BondAnswer answer_bond(const BondConstants& law,
                                                             const double* __restrict values,
                                                             const BondMotion& m) {
  BondAnswer r;
  const double dux = m.dux, duy = m.duy, turn = m.turn;
  const double dx = values[block_dx], dy = values[block_dy], length = values[block_length],
               arm_i = values[block_arm], arm_j = length - arm_i;
  const double lx = dx + dux, ly = dy + duy;
  const double now = __builtin_sqrt(lx * lx + ly * ly);
  // One division for 1 / L, 1 / (L + L0) and 1 / L0.
  const double both = now + length, at_once = 1.0 / (now * length * both);
  const double inverse = at_once * (length * both), inverse_length = at_once * (now * both);
  const double gap = (2.0 * (dx * dux + dy * duy) + (dux * dux + duy * duy)) * (at_once * (now * length)) -
                     (varied ? m.growth : 0.0);
  const double share = varied ? m.stiffness : 1.0;
  const double nx = lx * inverse, ny = ly * inverse;
  const double ratio = length * inverse;
  const double sine = (dx * duy - dy * dux) * inverse;  // times L0
  const double s = sine * inverse_length, s2 = s * s;
  const double shear = sine * (1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0 + s2 * (15.0 / 336.0)))) -
                       (length * m.theta_i + arm_j * turn);

  const double intact = m.intact, radius = values[block_radius];
  double bond_n = law.bond_normal * share * intact * gap;
  double bond_s = law.bond_shear * share * intact * shear;
  double bend = law.bond_normal * share * intact * radius * turn;  // 3 M / R
  if constexpr (softens) {
    constexpr double none = 1e-300;
    const double open = positive(gap);
    const double w = __builtin_sqrt(open * open + law.shear_per_normal * shear * shear +
                                    radius * radius * (1.0 / 3.0) * turn * turn);
    const double pulled = (bond_n + law.bending_share * magnitude(bend)) / (law.tensile * radius * m.tensile),
                 sheared = magnitude(bond_s) / (law.shearing * radius * m.shear);
    const double stress = pulled > sheared ? pulled : sheared;
    const double begins = stress >= 1.0 ? w / (stress + none) : 0.0;
    const double start = m.start > 0.0 ? m.start : begins;
    const double soft = law.softening * radius / (law.bond_normal * share * start + none),
                 steep = steepest_softening * start + none, end = soft > steep ? soft : steep;
    const double farthest = w > m.worst ? w : m.worst, reached = farthest < end ? farthest : end;
    const bool damaged = intact > 0.0 && start > 0.0;
    const double worst = damaged ? reached : m.worst;
    const double kept = damaged && worst > start ? start * (end - worst) / (worst * (end - start)) : 1.0;
    bond_n *= gap > 0.0 ? kept : 1.0;
    bond_s *= kept;
    bend *= kept;
    r.start = start;
    r.worst = worst;
    r.over = damaged && worst >= end ? 1.0 : 0.0;
  }

  const double present = intact > 0.0 ? law.contact_with_bond : 1.0;
  double squeeze = positive(-gap), contact_bend = 0.0;  // over stiffness
  if constexpr (flat) {
    const double edge = radius * magnitude(turn);
    const double deep = positive(edge - gap), part = deep / (edge + 1e-300);
    const bool whole = -gap >= edge;
    squeeze = whole ? -gap : 0.25 * deep * part;
    contact_bend = whole ? edge : squeeze * (3.0 - part);
    contact_bend = turn < 0.0 ? -contact_bend : contact_bend;
  }
  const double contact_n = law.contact_normal * share * present * squeeze;
  const double moment =
      (flat ? bend + law.contact_normal * share * present * contact_bend : bend) * radius * (1.0 / 3.0);
  const double limit = (varied ? m.friction : law.friction) * contact_n;
  const double trial = law.contact_shear * share * (shear - m.slip);
  // In the order of operands in which one instruction each does it.
  const double below = limit < trial ? limit : trial, contact_s = -limit > below ? -limit : below;
  r.slip = magnitude(trial) > limit ? shear - contact_s * (law.inverse_contact_shear / share) : m.slip;
  r.friction = magnitude(contact_s * (r.slip - m.slip));

  const double normal = bond_n - contact_n, tangential = bond_s + contact_s;
  const double across = tangential * ratio;
  r.fx = normal * nx - across * ny;
  r.fy = normal * ny + across * nx;
  r.moment_i = tangential * arm_i + moment;
  r.minus_moment_j = moment - tangential * arm_j;
  r.force = magnitude(r.fx) + magnitude(r.fy);

  // Excess over strength, as a number so that the loop stays in vector registers; a broken bond has none.
  const double pull =
      bond_n + law.bending_share * magnitude(bend) - law.tensile * radius * (varied ? m.tensile : 1.0);
  const double push = magnitude(bond_s) - law.shearing * radius * (varied ? m.shear : 1.0);
  const double excess = pull > push ? pull : push;
  if constexpr (!softens) r.over = intact > 0.0 && excess >= 0.0 ? 1.0 : 0.0;
  return r;
}

// A contact of a smooth joint, by the law of solid/smooth_joints.hpp where it has no dilation and a constant friction.
// Lanes::Value: a number, or several side by side.
template <class Lanes>
struct ContactPlace {
  using T = typename Lanes::Value;
  T nx, ny, area, opens_i, opens_j, slides_i, slides_j;
  T open_before, slid_before, locked_normal, locked_shear;  // what it was settled with
};

template <class Lanes>
struct ContactLaw {
  using T = typename Lanes::Value;
  T normal, shear, inverse_closure, last_closure, friction, tensile, cohesion, intact_friction;
  ContactLaw() = default;
  explicit ContactLaw(const SmoothLaw& s)
      : normal{s.normal},
        shear{s.shear},
        inverse_closure{s.inverse_closure},
        last_closure{s.last_closure},
        friction{s.friction},
        tensile{s.tensile},
        cohesion{s.cohesion},
        intact_friction{s.intact_friction} {}
};

template <class Lanes>
struct ContactMotion {
  using T = typename Lanes::Value;
  T dux, duy, theta_i, turn, slip, intact;
};

template <class Lanes>
struct ContactAnswer {
  using T = typename Lanes::Value;
  T fx, fy, moment_i, minus_moment_j, slip, friction, over;
};

template <class Lanes>
inline __attribute__((always_inline)) ContactAnswer<Lanes> answer_contact(const ContactPlace<Lanes>& c,
                                                                          const ContactLaw<Lanes>& law,
                                                                          const ContactMotion<Lanes>& m) {
  using T = typename Lanes::Value;
  const T zero{}, one = zero + 1.0;
  const T theta_j = m.theta_i + m.turn;
  const auto holds = m.intact > zero, loose = m.intact <= zero;

  const T opening = m.dux * c.nx + m.duy * c.ny + c.opens_i * m.theta_i + c.opens_j * theta_j - c.open_before;
  const T slide = m.duy * c.nx - m.dux * c.ny + c.slides_i * m.theta_i + c.slides_j * theta_j - c.slid_before;
  const T closure = opening < zero ? -opening : zero, open = opening > zero ? opening : zero;
  const T bent = closure < law.last_closure ? closure : law.last_closure;
  const T room = one / (one - bent * law.inverse_closure);
  const T kn = c.area * law.normal, ks = c.area * law.shear;
  const T pressed = kn * room * (bent + room * (closure - bent));
  const T trial = ks * (slide - (holds ? zero : m.slip)), limit = law.friction * pressed;
  const T at_limit = trial < zero ? -limit : limit;
  const auto slides = ((trial > limit) | (-trial > limit)) & loose;
  const T shear = slides ? at_limit : trial;
  ContactAnswer<Lanes> r;
  r.slip = slides ? slide - (ks > zero ? shear / ks : zero) : m.slip;
  const T normal = (holds ? kn * open : zero) - pressed;
  const T pull = normal - law.tensile * c.area,
          push = (shear < zero ? -shear : shear) - (law.cohesion * c.area + law.intact_friction * pressed);
  const auto breaks = ((pull > push ? pull : push) >= zero) & holds;
  const T along = normal + c.locked_normal, across = shear + c.locked_shear;
  r.fx = along * c.nx - across * c.ny;
  r.fy = along * c.ny + across * c.nx;
  // Once the faces have moved apart the two forces lie on two lines: what that turns is shared.
  const T couple = 0.5 * (m.dux * r.fy - m.duy * r.fx);
  r.moment_i = couple - (c.opens_i * along + c.slides_i * across);
  r.minus_moment_j = c.opens_j * along + c.slides_j * across - couple;
  const T work = shear * (r.slip - m.slip);
  r.friction = work < zero ? -work : work;
  r.over = breaks ? one : zero;
  return r;
}

// Of a pore whose volume has changed by `change` since bonding (eq. 8 in total form); stiffness 0: it keeps its pressure.
inline __attribute__((always_inline)) double pore_pressure(double reference, double floor, double stiffness,
                                                           double content, double change, double before) {
  const double full = reference + stiffness * (content - change);
  const double p = full > floor ? full : floor;  // cavitation
  return stiffness > 0.0 ? p : before;
}

// Pressure p of such a domain; returns the work it did on the way.
inline double undrained_pressure(const KernelArrays& a, int64_t d, double change, double& p) {
  const double before = a.pressure[d];
  p = pore_pressure(a.reference_pressure, a.floor_pressure, a.stiffness[d], a.content[d], change, before);
  const double work = 0.5 * (before + p) * (change - a.volume_change[d]);
  a.pressure[d] = p;
  a.volume_change[d] = change;
  return work;
}

// One degree of freedom of a disc: leap-frog with local damping (Cundall 1987). Returns the damping work.
inline __attribute__((always_inline)) double move(double step, double damping, double force,
                                                  double inverse_mass, double& velocity,
                                                  double& displacement) {
  const double v = velocity, against = v > 0.0 ? 1.0 : (v < 0.0 ? -1.0 : 0.0);
  const double drag = damping * magnitude(force) * against;
  const double after = v + step * (force - drag) * inverse_mass;
  velocity = after;
  displacement += step * after;
  return 0.5 * step * drag * (v + after);
}

}  // namespace
}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac
