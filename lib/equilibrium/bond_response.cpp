// SPDX-License-Identifier: BSD-3-Clause
#include "equilibrium/bond_response.hpp"

#include <algorithm>
#include <cmath>

#include "solid/bond_law.hpp"
#include "solid/smooth_joints.hpp"

namespace hfrac {
namespace {

// Stiffnesses and forces along the three ways a pair can move.
struct Components {
  double normal = 0.0, shear = 0.0, moment = 0.0;  // N, N, N m
  double normal_stiffness = 0.0, shear_stiffness = 0.0, shear_by_gap = 0.0, moment_stiffness = 0.0;
  double normal_by_bend = 0.0, shear_by_bend = 0.0;  // N, N; the first is the moment's by the gap too
};

void fill(BondResponse& r, const Components& c, Vec2 n, double now, double length, double arm_i,
          double arm_j) {
  const Vec2 t{-n.y, n.x};
  const double turn = length / now;  // du_s / d(displacement along t)
  r.normal = c.normal;
  r.shear = c.shear;
  r.normal_stiffness = c.normal_stiffness;
  r.direction = n;
  r.force[0] = c.normal * n.x + c.shear * turn * t.x;
  r.force[1] = c.normal * n.y + c.shear * turn * t.y;
  r.force[2] = -(c.shear * arm_i + c.moment);
  r.force[3] = -(c.shear * arm_j - c.moment);
  const double nn = c.normal_stiffness, tt = c.shear_stiffness * turn * turn + c.normal / now,
               bent = -c.shear * length / (now * now), tn = c.shear_by_gap * turn;
  double* k = r.tangent;
  k[0] = nn * n.x * n.x + tt * t.x * t.x + (2.0 * bent + tn) * t.x * n.x;
  k[1] = nn * n.x * n.y + tt * t.x * t.y + bent * (n.x * t.y + t.x * n.y) + tn * t.x * n.y;
  k[4] = nn * n.x * n.y + tt * t.x * t.y + bent * (n.x * t.y + t.x * n.y) + tn * t.y * n.x;
  k[5] = nn * n.y * n.y + tt * t.y * t.y + (2.0 * bent + tn) * t.y * n.y;
  const double across = c.shear_stiffness * turn;
  k[2] = -across * arm_i * t.x;
  k[3] = -across * arm_j * t.x;
  k[6] = -across * arm_i * t.y;
  k[7] = -across * arm_j * t.y;
  k[8] = k[2] - arm_i * c.shear_by_gap * n.x;
  k[9] = k[6] - arm_i * c.shear_by_gap * n.y;
  k[12] = k[3] - arm_j * c.shear_by_gap * n.x;
  k[13] = k[7] - arm_j * c.shear_by_gap * n.y;
  k[10] = c.shear_stiffness * arm_i * arm_i + c.moment_stiffness;
  k[11] = k[14] = c.shear_stiffness * arm_i * arm_j - c.moment_stiffness;
  k[15] = c.shear_stiffness * arm_j * arm_j + c.moment_stiffness;
  if (c.normal_by_bend == 0.0) return;
  const Vec2 pull = c.normal_by_bend * n, all = pull + (c.shear_by_bend * turn) * t;
  k[2] -= all.x;
  k[3] += all.x;
  k[6] -= all.y;
  k[7] += all.y;
  k[8] -= pull.x;
  k[9] -= pull.y;
  k[12] += pull.x;
  k[13] += pull.y;
  k[10] += arm_i * c.shear_by_bend;
  k[11] -= arm_i * c.shear_by_bend;
  k[14] += arm_j * c.shear_by_bend;
  k[15] -= arm_j * c.shear_by_bend;
}

struct ContactLaw {
  double normal_stiffness, shear_stiffness, friction;  // N/m, N/m, 1
};

// Adds a frictional contact pressed together by `squeeze` >= 0 whose shear spring would bear `trial`.
void add_contact(Components& c, const ContactLaw& law, double squeeze, double trial) {
  c.normal -= squeeze;
  c.normal_stiffness += law.normal_stiffness;
  const double limit = law.friction * squeeze;
  if (std::abs(trial) <= limit) {
    c.shear += trial;
    c.shear_stiffness += law.shear_stiffness;
  } else {
    c.shear += std::copysign(limit, trial);
    c.shear_by_gap -= std::copysign(law.friction * law.normal_stiffness, trial);
  }
}

// A smooth joint's contact: linear in q but for the kinks of its law and a couple.
BondResponse respond_smooth(const Assembly& a, const SmoothContact& contact) {
  const SmoothResponse s = smooth_response(a, contact);
  const SettledContact locked = a.smooth.settled_of(contact);
  const Vec2 n = contact.normal;
  const double opens[4] = {n.x, n.y, contact.opens_by_first, contact.opens_by_second},
               slides[4] = {-n.y, n.x, contact.slides_by_first, contact.slides_by_second};
  BondResponse r{};
  r.gap = s.opening;
  r.normal = s.normal;
  r.shear = s.shear;
  r.normal_stiffness = s.normal_stiffness;
  r.direction = n;
  for (int row = 0; row < 4; ++row) {
    r.force[row] =
        (s.normal + locked.locked_normal) * opens[row] + (s.shear + locked.locked_shear) * slides[row];
    for (int column = 0; column < 4; ++column) {
      r.tangent[4 * row + column] =
          opens[row] * (s.normal_stiffness * opens[column] + s.normal_by_slide * slides[column]) +
          slides[row] * (s.shear_stiffness * slides[column] + s.shear_by_opening * opens[column]);
    }
  }
  // The faces' forces lie on two lines once they have moved: half the couple on either disc (answer_of).
  const auto first = a.first[contact.bond], second = a.second[contact.bond];
  const Vec2 moved{a.ux[second] - a.ux[first], a.uy[second] - a.uy[first]};
  const double couple = 0.5 * (moved.x * r.force[1] - moved.y * r.force[0]);
  for (int column = 0; column < 4; ++column) {
    double by = 0.5 * (moved.x * r.tangent[4 + column] - moved.y * r.tangent[column]);
    if (column == 0) by += 0.5 * r.force[1];
    if (column == 1) by -= 0.5 * r.force[0];
    r.tangent[8 + column] -= by;
    r.tangent[12 + column] -= by;
  }
  r.force[2] -= couple;
  r.force[3] -= couple;
  return r;
}

// A bond that softens just now keeps less of its forces the farther it goes: they change by the change of what is kept, too.
void add_softening(BondResponse& r, const BondLaw& law, const Options& o, double share, double radius) {
  const PairMotion& m = law.motion;
  const Vec2 n = m.normal, t{-n.y, n.x};
  const double turn = m.length / m.now, normal = o.bond_normal_stiffness * share;
  const double ways[3][4] = {
      {n.x, n.y, 0.0, 0.0}, {turn * t.x, turn * t.y, -m.arm_i, -m.arm_j}, {0.0, 0.0, -1.0, 1.0}};
  const double whole[3] = {normal * std::max(0.0, m.gap), o.bond_shear_stiffness * share * m.shear,
                           normal * radius * radius / 3.0 * m.bend};
  const double change[3] = {law.softened.by_gap, law.softened.by_shear, law.softened.by_bend};
  r.normal_stiffness += whole[0] * change[0];
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      double force = 0.0, kept = 0.0;
      for (int way = 0; way < 3; ++way) {
        force += whole[way] * ways[way][row];
        kept += change[way] * ways[way][column];
      }
      r.tangent[4 * row + column] += force * kept;
    }
  }
}

}  // namespace

BondResponse respond(const Assembly& a, const Options& o, std::int64_t e) {
  if (const SmoothContact* contact = a.smooth.of(e)) return respond_smooth(a, *contact);
  const BondLaw law = bond_law(a, o, e);
  const PairMotion& m = law.motion;
  BondResponse r;
  r.gap = m.gap;
  Components c;
  c.normal = law.bond_normal;
  c.shear = law.bond_shear;
  c.moment = law.bond_moment;
  c.normal_stiffness = law.bond_stiffness;
  c.shear_stiffness = law.bond_shear_stiffness;
  c.moment_stiffness = law.bond_moment_stiffness;
  if (law.pressed) {
    c.normal -= law.contact_normal;
    c.shear += law.contact_shear;
    c.normal_stiffness += law.contact_stiffness;
    c.moment += law.contact_moment;
    c.moment_stiffness += law.contact_moment_stiffness;
    c.normal_by_bend = law.contact_coupling;
    if (law.slides) {
      c.shear_by_gap -= std::copysign(law.friction * law.contact_stiffness, law.contact_shear);
      c.shear_by_bend = std::copysign(law.friction, -law.contact_shear) * law.contact_coupling;
    } else {
      c.shear_stiffness += law.contact_shear_stiffness;
    }
  }
  fill(r, c, m.normal, m.now, m.length, m.arm_i, m.arm_j);
  if (law.softened.by_gap != 0.0 || law.softened.by_shear != 0.0 || law.softened.by_bend != 0.0)
    add_softening(r, law, o, a.factors.stiffness_of(e), a.bond_radius(e));
  return r;
}

BondResponse respond(const Assembly& a, const Options& o, const NonBondedContacts::Pair& pair,
                     const PairStart& start) {
  const auto i = pair.first, j = pair.second;
  const Vec2 d = a.position(j) - a.position(i);
  const double now = norm(d), touch = a.radius[i] + a.radius[j];
  BondResponse r{};
  r.gap = now - touch - pair.reference_gap - a.thermal.growth_of(i) - a.thermal.growth_of(j);
  r.direction = (1.0 / now) * d;
  if (r.gap >= 0.0) return r;
  const double share = now / touch, arm_i = share * a.radius[i], arm_j = share * a.radius[j];
  const Vec2 moved = d - start.between, t{-r.direction.y, r.direction.x};
  const double slide =
      dot(moved, t) - arm_i * (a.rotation[i] - start.first) - arm_j * (a.rotation[j] - start.second);
  Components c;
  const double stiffness = a.thermal.pair_stiffness(i, j);
  const ContactLaw law{o.contact_normal_stiffness * stiffness, o.contact_shear_stiffness * stiffness,
                       o.contact_friction * a.thermal.pair_friction(i, j)};
  add_contact(c, law, -law.normal_stiffness * r.gap, pair.shear_force + law.shear_stiffness * slide);
  fill(r, c, r.direction, now, now, arm_i, arm_j);
  return r;
}

BondResponse respond(const Assembly& a, const Options& o, const Network& network, const Facets& facets,
                     const Facet& f) {
  BondResponse r{};
  r.gap = facets.opening(a, network, f);
  r.direction = f.normal;
  r.force[0] = f.locked.x;
  r.force[1] = f.locked.y;
  r.force[2] = f.locked_first;
  r.force[3] = f.locked_second;
  if (r.gap >= 0.0) return r;
  const auto e = f.bond;
  const Vec2 n = f.normal, t{-n.y, n.x};
  const double arm_i = a.arm(e), arm_j = a.length(e) - arm_i;
  const double k = facets.start().stiffness;
  const ClosedFacet c = closed_facet(a, o, facets.start(), f, r.gap);
  r.normal = c.normal;
  r.normal_stiffness = k;
  r.shear = c.shear;
  double shear_stiffness = o.contact_shear_stiffness, by_gap = 0.0;
  if (c.slides != 0.0) {
    shear_stiffness = 0.0;
    by_gap = -std::copysign(o.contact_friction * k, c.slides);
    r.by_push = -std::copysign(o.contact_friction, c.slides);
  }
  const double opens[4] = {n.x, n.y, 0.0, 0.0}, slides[4] = {t.x, t.y, -arm_i, -arm_j};
  for (int row = 0; row < 4; ++row) {
    r.force[row] += r.normal * opens[row] + r.shear * slides[row];
    for (int column = 0; column < 4; ++column)
      r.tangent[4 * row + column] = k * opens[row] * opens[column] +
                                    slides[row] * (shear_stiffness * slides[column] + by_gap * opens[column]);
  }
  return r;
}

}  // namespace hfrac
