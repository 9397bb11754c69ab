// SPDX-License-Identifier: BSD-3-Clause
#include "solid/bond_law.hpp"

#include <algorithm>
#include <cmath>

#include "options/choices.hpp"
#include "solid/smooth_joints.hpp"

namespace hfrac {
namespace {

// How far the centres are apart, at bonding and now.
struct Stretch {
  Vec2 before, change;      // m, from first to second disc
  double length, now, gap;  // m, as in PairMotion
};
Stretch stretch_of(const Assembly& a, std::size_t part, std::int64_t e) {
  const auto i = a.first[e], j = a.second[e];
  const auto value = [&](std::int64_t row) { return a.geometry.at(part, e, row); };
  Stretch s{{value(block_dx), value(block_dy)},
            {a.ux[j] - a.ux[i], a.uy[j] - a.uy[i]},
            value(block_length),
            0.0,
            0.0};
  s.now = norm(s.before + s.change);
  s.gap =
      (2.0 * dot(s.before, s.change) + dot(s.change, s.change)) / (s.now + s.length) - a.factors.growth_of(e);
  return s;
}

PairMotion motion_of(const Assembly& a, std::int64_t e) {
  const auto i = a.first[e], j = a.second[e];
  const auto part = a.part_of(e);
  const Stretch s = stretch_of(a, part, e);
  PairMotion m{};
  m.now = s.now;
  m.length = s.length;
  m.arm_i = a.geometry.at(part, e, block_arm);
  m.arm_j = m.length - m.arm_i;
  m.normal = (1.0 / m.now) * (s.before + s.change);
  m.gap = s.gap;
  // L0 asin(sine / L0) to the seventh order.
  const double sine = cross(s.before, s.change) / m.now, s2 = sine * sine / (m.length * m.length);
  m.shear = sine * (1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0 + s2 * (15.0 / 336.0)))) -
            (m.arm_i * a.rotation[i] + m.arm_j * a.rotation[j]);
  m.bend = a.rotation[j] - a.rotation[i];
  return m;
}

// Of a contact that is closed at least in part: a line of springs that bear pressure only (kernels_law.hpp), whose ends `edge` [m] is
// how far from the mean gap [N].
double contact_force(double stiffness, double gap, double edge) {
  if (-gap >= edge) return -stiffness * gap;
  const double deep = edge - gap;
  return 0.25 * stiffness * deep * (deep / edge);
}

// The contact's normal force and moment by gap and bend.
void press(BondLaw& law, double stiffness, double radius, bool flat) {
  const PairMotion& m = law.motion;
  const double edge = flat ? radius * std::abs(m.bend) : 0.0;
  law.contact_stiffness = stiffness;
  law.contact_normal = contact_force(stiffness, m.gap, edge);
  if (-m.gap >= edge) {
    law.contact_energy = 0.5 * law.contact_normal * std::max(0.0, -m.gap);
    if (!flat) return;
    law.contact_moment_stiffness = stiffness * radius * radius / 3.0;
    law.contact_moment = law.contact_moment_stiffness * m.bend;
    law.contact_energy += 0.5 * law.contact_moment * m.bend;
    return;
  }
  const double deep = edge - m.gap, part = deep / edge;
  law.contact_stiffness = 0.5 * stiffness * part;
  law.contact_moment = std::copysign(law.contact_normal * radius * (1.0 - part / 3.0), m.bend);
  law.contact_moment_stiffness = stiffness * radius * radius * part * (3.0 - 3.0 * part + part * part) / 6.0;
  law.contact_coupling = -std::copysign(0.25 * stiffness * radius * part * (2.0 - part), m.bend);
  law.contact_energy = law.contact_normal * deep / 3.0;
}

// What is left of a bond that softens; pressure it bears whole.
void weaken(BondLaw& law, const Assembly& a, const Options& o, std::int64_t e) {
  law.softened = soften(a, o, e, law.motion);
  const double kept = law.softened.kept;
  if (law.motion.gap > 0.0) {
    law.bond_stiffness *= kept;
    law.bond_normal *= kept;
  }
  law.bond_shear_stiffness *= kept;
  law.bond_moment_stiffness *= kept;
  law.bond_shear *= kept;
  law.bond_moment *= kept;
}

}  // namespace

BondLaw bond_law(const Assembly& a, const Options& o, std::int64_t e) {
  BondLaw law;
  law.motion = motion_of(a, e);
  const PairMotion& m = law.motion;
  const double share = a.factors.stiffness_of(e);
  const bool intact = a.intact[e] != 0;
  if (intact) {
    const double radius = a.bond_radius(e);
    law.bond_stiffness = o.bond_normal_stiffness * share;
    law.bond_shear_stiffness = o.bond_shear_stiffness * share;
    law.bond_moment_stiffness = law.bond_stiffness * radius * radius / 3.0;
    law.bond_normal = law.bond_stiffness * m.gap;
    law.bond_shear = law.bond_shear_stiffness * m.shear;
    law.bond_moment = law.bond_moment_stiffness * m.bend;
    if (!a.softening.empty()) weaken(law, a, o, e);
  }
  const bool flat = ContactShape{o.contact_shape} == ContactShape::flat;
  const double edge = flat ? a.bond_radius(e) * std::abs(m.bend) : 0.0;
  law.pressed = m.gap < edge && (!intact || ContactMode{o.contact_mode} == ContactMode::parallel);
  if (!law.pressed) return law;
  law.contact_shear_stiffness = o.contact_shear_stiffness * share;
  law.friction = a.factors.friction_of(e, o.contact_friction);
  press(law, o.contact_normal_stiffness * share, a.bond_radius(e), flat);
  const double limit = law.friction * law.contact_normal,
               trial = law.contact_shear_stiffness * (m.shear - a.slip[e]);
  law.slides = !(std::abs(trial) <= limit);
  law.contact_shear = law.slides ? std::copysign(limit, trial) : trial;
  return law;
}

NormalView view_normal(const Assembly& a, const Options& o, std::size_t part, std::int64_t e) {
  if (!a.softening.empty() || a.smooth.of(e) != nullptr) {
    const BondView view = view_bond(a, o, e);
    return {view.gap, view.normal_force()};
  }
  const double gap = stretch_of(a, part, e).gap, share = a.factors.stiffness_of(e);
  const bool intact = a.intact[e] != 0;
  const double pull = intact ? o.bond_normal_stiffness * share * gap : 0.0;
  const double edge =
      ContactShape{o.contact_shape} == ContactShape::flat
          ? a.geometry.at(part, e, block_radius) * std::abs(a.rotation[a.second[e]] - a.rotation[a.first[e]])
          : 0.0;
  const bool pressed = gap < edge && (!intact || ContactMode{o.contact_mode} == ContactMode::parallel);
  return {gap, pressed ? pull - contact_force(o.contact_normal_stiffness * share, gap, edge) : pull};
}

BondView view_bond(const Assembly& a, const Options& o, std::int64_t e) {
  if (const SmoothContact* contact = a.smooth.of(e)) return view_smooth(a, *contact);
  const BondLaw law = bond_law(a, o, e);
  const PairMotion& m = law.motion;
  BondView v{};
  v.gap = m.gap;
  v.shear = m.shear;
  v.normal = m.normal;
  v.first_arm = m.arm_i * m.normal;
  v.second_arm = -m.arm_j * m.normal;
  v.bond_normal = law.bond_normal;
  v.bond_shear = law.bond_shear;
  v.bond_moment = law.bond_moment;
  v.bond_energy = 0.5 * (v.bond_normal * m.gap + v.bond_shear * m.shear + v.bond_moment * m.bend);
  v.contact_normal = law.contact_normal;
  v.contact_shear = law.contact_shear;
  v.contact_moment = law.contact_moment;
  v.contact_energy = law.contact_energy;
  if (law.contact_shear_stiffness > 0.0)
    v.contact_energy += 0.5 * v.contact_shear * v.contact_shear / law.contact_shear_stiffness;
  if (!a.softening.empty()) {
    const bool pulled = law.softened.tensile >= law.softened.shear;
    v.tensile_excess = pulled ? law.softened.spent : 0.0;
    v.shear_excess = pulled ? 0.0 : law.softened.spent;
    return v;
  }
  const double pull =
      v.bond_normal + o.bond_moment_contribution * 3.0 * std::abs(v.bond_moment) / a.bond_radius(e);
  const double tensile = a.tensile_capacity(e), shearing = a.shear_capacity(e);
  v.tensile_excess = tensile > 0.0 ? pull / tensile : (pull >= 0.0 ? 1.0 : 0.0);
  v.shear_excess = shearing > 0.0 ? std::abs(v.bond_shear) / shearing : 1.0;
  return v;
}

}  // namespace hfrac
