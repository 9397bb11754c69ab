// SPDX-License-Identifier: BSD-3-Clause
#include "solid/smooth_joints.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solid/boundary.hpp"

namespace hfrac {
namespace {

constexpr double widest_gap = 4.0;       // mean radii between contacts: beyond, the joint runs through a hole
constexpr double smallest_piece = 0.01;  // mean radii

Vec2 turned(Vec2 v) {
  return {-v.y, v.x};
}

// A bond and where it meets a joint; the discs on the joint's left and right, and their feet on it. All along the joint [m].
struct Crossing {
  std::int64_t bond;
  double at;
  std::int32_t disc[2];
  double foot[2];
};
Crossing crossing_of(const Assembly& a, std::int64_t e, Vec2 from, Vec2 along) {
  Crossing c{};
  const Vec2 p{a.x[a.first[e]], a.y[a.first[e]]}, bond{a.dx(e), a.dy(e)};
  c.bond = e;
  c.at = dot(p + (cross(from - p, along) / cross(bond, along)) * bond - from, along);
  const bool first_left = cross(along, p - from) > 0.0;
  c.disc[0] = first_left ? a.first[e] : a.second[e];
  c.disc[1] = first_left ? a.second[e] : a.first[e];
  for (int side = 0; side < 2; ++side)
    c.foot[side] = dot(Vec2{a.x[c.disc[side]], a.y[c.disc[side]]} - from, along);
  return c;
}

struct Piece {
  std::int64_t bond;
  double begin, end;
};
// Shares the joint out. Going along it, from one contact to the next the disc on one side changes, or on both: there ends the
// first disc's face, between its foot and the next one's as their radii are. Faces that would begin before they end are
// cut at their mean. At its ends the joint reaches as far as both discs' faces. So each disc is pressed about evenly around its foot, whatever way its contacts look.
std::vector<Piece> pieces_of(const Assembly& a, std::vector<Crossing>& met, double length) {
  std::sort(met.begin(), met.end(), [](const Crossing& p, const Crossing& q) {
    return p.at != q.at ? p.at < q.at : p.bond < q.bond;
  });
  const auto rim = [&](const Crossing& c, int side, double way) {
    return c.foot[side] + way * a.radius[c.disc[side]];
  };
  std::vector<Piece> pieces;
  for (std::size_t first = 0; first < met.size();) {
    std::size_t last = first;
    while (last + 1 < met.size() && met[last + 1].at - met[last].at <= widest_gap * a.mean_radius) ++last;
    struct Cut {
      double at, count;
    };
    std::vector<Cut> cuts;  // each of one or several contacts' ends
    for (std::size_t m = first; m < last; ++m) {
      double sum = 0.0, count = 0.0;
      for (int side = 0; side < 2; ++side) {
        const auto d = met[m].disc[side], next = met[m + 1].disc[side];
        if (d == next) continue;
        sum += met[m].foot[side] +
               (met[m + 1].foot[side] - met[m].foot[side]) * a.radius[d] / (a.radius[d] + a.radius[next]);
        count += 1.0;
      }
      cuts.push_back({count > 0.0 ? sum / count : 0.5 * (met[m].at + met[m + 1].at), 1.0});
      while (cuts.size() > 1 && cuts[cuts.size() - 2].at > cuts.back().at) {
        const Cut late = cuts.back();
        cuts.pop_back();
        Cut& early = cuts.back();
        early.at = (early.at * early.count + late.at * late.count) / (early.count + late.count);
        early.count += late.count;
      }
    }
    std::vector<double> ends;
    for (const auto& cut : cuts) ends.insert(ends.end(), static_cast<std::size_t>(cut.count), cut.at);
    double begin = std::clamp(std::max(rim(met[first], 0, -1.0), rim(met[first], 1, -1.0)), 0.0, length);
    const double stop = std::clamp(std::min(rim(met[last], 0, 1.0), rim(met[last], 1, 1.0)), begin, length);
    for (std::size_t m = first; m <= last; ++m) {
      const double end = m < last ? std::clamp(ends[m - first], begin, stop) : stop;
      pieces.push_back({met[m].bond, begin, end});
      begin = end;
    }
    first = last + 1;
  }
  return pieces;
}

// The motion of the faces at a contact, less what the discs grew by temperature.
struct Motion {
  double opening, slide;
};
Motion motion_of(const Assembly& a, const SmoothContact& c) {
  const auto i = a.first[c.bond], j = a.second[c.bond];
  const double share = a.factors.growth_of(c.bond) / a.length(c.bond);
  const Vec2 between{a.ux[j] - a.ux[i] - share * a.dx(c.bond), a.uy[j] - a.uy[i] - share * a.dy(c.bond)};
  return {dot(between, c.normal) + c.opens_by_first * a.rotation[i] + c.opens_by_second * a.rotation[j],
          dot(between, turned(c.normal)) + c.slides_by_first * a.rotation[i] +
              c.slides_by_second * a.rotation[j]};
}

}  // namespace

bool crosses(const JointOptions& joint, Vec2 p, Vec2 q) {
  return crosses({joint.x1, joint.y1}, {joint.x2, joint.y2}, p, q);
}

void begin_smooth_joints(Assembly& a, const std::vector<JointOptions>& joints,
                         const std::vector<std::int32_t>& joint_of, const Options& o) {
  SmoothJoints& smooth = a.smooth;
  const double diameter = 2.0 * a.mean_radius;
  smooth.normal_stiffness = o.smooth_joint_normal_stiffness > 0.0 ? o.smooth_joint_normal_stiffness
                                                                  : o.contact_normal_stiffness / diameter;
  smooth.shear_stiffness = o.smooth_joint_shear_stiffness > 0.0 ? o.smooth_joint_shear_stiffness
                                                                : o.contact_shear_stiffness / diameter;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const JointOptions& joint = joints[k];
    if (!is_smooth(JointState{joint.state})) continue;
    const Vec2 from{joint.x1, joint.y1}, to{joint.x2, joint.y2};
    smooth.lines.push_back({from, to});
    const double length = std::sqrt(dot(to - from, to - from));
    const Vec2 along = (1.0 / length) * (to - from);
    std::vector<Crossing> met;
    for (std::int64_t e = 0; e < a.bond_count(); ++e) {
      if (joint_of[static_cast<std::size_t>(e)] == static_cast<std::int32_t>(k))
        met.push_back(crossing_of(a, e, from, along));
    }
    for (const auto& piece : pieces_of(a, met, length)) {
      const std::int64_t e = piece.bond;
      const auto i = a.first[e], j = a.second[e];
      const Vec2 place = from + 0.5 * (piece.begin + piece.end) * along;
      SmoothContact c{};
      c.bond = e;
      c.joint = static_cast<std::int64_t>(k);
      c.normal = dot(turned(along), {a.dx(e), a.dy(e)}) > 0.0 ? turned(along) : -1.0 * turned(along);
      c.first_arm = place - Vec2{a.x[i], a.y[i]};
      c.second_arm = place - Vec2{a.x[j], a.y[j]};
      c.opens_by_first = -dot(c.normal, turned(c.first_arm));
      c.opens_by_second = dot(c.normal, turned(c.second_arm));
      c.slides_by_first = -dot(turned(c.normal), turned(c.first_arm));
      c.slides_by_second = dot(turned(c.normal), turned(c.second_arm));
      c.area = std::max(piece.end - piece.begin, smallest_piece * a.mean_radius);
      c.holds = a.intact[e] != 0;
      smooth.contacts.push_back(c);
    }
  }
  if (smooth.contacts.empty()) return;
  std::sort(smooth.contacts.begin(), smooth.contacts.end(),
            [](const SmoothContact& p, const SmoothContact& q) { return p.bond < q.bond; });
  smooth.place.assign(static_cast<std::size_t>(a.bond_count()), -1);
  for (std::size_t k = 0; k < smooth.contacts.size(); ++k)
    smooth.place[static_cast<std::size_t>(smooth.contacts[k].bond)] = static_cast<std::int32_t>(k);
}

double smooth_opening(const Assembly& a, const SmoothContact& contact) {
  return motion_of(a, contact).opening;
}

double joint_opening(const Assembly& a, std::int64_t bond) {
  if (a.joint_normal.empty() || a.intact[bond] != 0) return 0.0;
  if (const SmoothContact* contact = a.smooth.of(bond)) {
    return std::max(0.0, smooth_opening(a, *contact));
  }
  const auto i = a.first[bond], j = a.second[bond];
  const double opening =
      dot({a.ux[j] - a.ux[i], a.uy[j] - a.uy[i]}, a.joint_normal[static_cast<std::size_t>(bond)]);
  return opening > 0.0 ? opening : 0.0;
}

SmoothResponse smooth_response(const Assembly& a, const Options& o, const SmoothContact& c) {
  const auto i = a.first[c.bond], j = a.second[c.bond];
  const Motion m = motion_of(a, c);
  const double share = a.thermal.pair_stiffness(i, j) * c.area, kn = a.smooth.normal_stiffness * share,
               ks = a.smooth.shear_stiffness * share;
  SmoothResponse r{m.opening, m.slide, 0.0, 0.0, c.slip, 0.0, 0.0, 0.0};
  if (c.holds) {
    r.normal = kn * m.opening;
    r.shear = ks * m.slide;
    r.normal_stiffness = kn;
    r.shear_stiffness = ks;
    return r;
  }
  const double squeeze = kn * std::max(0.0, -m.opening),
               friction = a.factors.friction_of(c.bond, o.contact_friction);
  const double limit = friction * squeeze, trial = ks * (m.slide - r.slipped);
  r.normal = -squeeze;
  if (m.opening < 0.0) r.normal_stiffness = kn;
  r.shear = std::clamp(trial, -limit, limit);
  if (std::abs(trial) > limit) {
    r.slipped = m.slide - (ks > 0.0 ? r.shear / ks : 0.0);
    r.shear_by_opening = -std::copysign(friction * r.normal_stiffness, trial);
  } else if (m.opening < 0.0) {
    r.shear_stiffness = ks;
  }
  return r;
}

BondView view_smooth(const Assembly& a, const Options& o, const SmoothContact& c) {
  const SmoothResponse r = smooth_response(a, o, c);
  const auto i = a.first[c.bond], j = a.second[c.bond];
  const double share = a.thermal.pair_stiffness(i, j) * c.area, kn = a.smooth.normal_stiffness * share,
               ks = a.smooth.shear_stiffness * share;
  BondView v{};
  v.gap = r.opening;
  v.shear = r.slide;
  v.normal = c.normal;
  v.first_arm = c.first_arm;
  v.second_arm = c.second_arm;
  double energy = 0.5 * r.normal * r.normal / kn;
  if (ks > 0.0) energy += 0.5 * r.shear * r.shear / ks;
  if (!c.holds) {
    v.contact_normal = -r.normal;
    v.contact_shear = r.shear;
    v.contact_energy = energy;
    v.shear_excess = v.tensile_excess = 0.0;
    return v;
  }
  v.bond_normal = r.normal;
  v.bond_shear = r.shear;
  v.bond_energy = energy;
  const double tensile = 0.5 * a.tensile_per_radius * a.factors.tensile_of(c.bond) * c.area,
               shearing = 0.5 * a.shear_per_radius * a.factors.shear_of(c.bond) * c.area +
                          a.factors.friction_of(c.bond, o.contact_friction) * std::max(0.0, -r.normal);
  v.tensile_excess = tensile > 0.0 ? r.normal / tensile : (r.normal >= 0.0 ? 1.0 : 0.0);
  v.shear_excess = shearing > 0.0 ? std::abs(r.shear) / shearing : 1.0;
  return v;
}

const SmoothContact* farthest_slide(const Assembly& a, double& slide) {
  const SmoothContact* farthest = nullptr;
  slide = 0.0;
  for (const auto& contact : a.smooth.contacts) {
    const double now = std::abs(motion_of(a, contact).slide);
    if (farthest != nullptr && now <= slide) continue;
    farthest = &contact;
    slide = now;
  }
  return farthest;
}

void release_smooth(Assembly& a, const Boundary& boundary) {
  for (const auto& contact : a.smooth.contacts) {
    for (const auto i : {a.first[contact.bond], a.second[contact.bond]}) {
      a.external_moment[i] = 0.0;
      if (boundary.touches_wall(i)) continue;  // written anew in every cycle
      const Vec2 load = boundary.load_on(i);
      a.external_x[i] = load.x;
      a.external_y[i] = load.y;
    }
  }
}

void add_smooth_force(Assembly& a, const Options& o, SmoothContact& c, double& friction) {
  const SmoothResponse r = smooth_response(a, o, c);
  friction += std::abs(r.shear * (r.slipped - c.slip));
  c.slip = r.slipped;
  const auto i = a.first[c.bond], j = a.second[c.bond];
  const Vec2 force = r.normal * c.normal + r.shear * turned(c.normal);
  a.external_x[i] += force.x;
  a.external_y[i] += force.y;
  a.external_x[j] -= force.x;
  a.external_y[j] -= force.y;
  // Once the faces have moved apart the two forces lie on two lines: what that turns is shared, so that a pair turns nothing.
  const double couple = 0.5 * cross(Vec2{a.ux[j] - a.ux[i], a.uy[j] - a.uy[i]}, force);
  a.external_moment[i] += couple - (c.opens_by_first * r.normal + c.slides_by_first * r.shear);
  a.external_moment[j] += couple - (c.opens_by_second * r.normal + c.slides_by_second * r.shear);
}

void keep_smooth_slips(Assembly& a, const Options& o, double& friction) {
  for (auto& contact : a.smooth.contacts) {
    const SmoothResponse r = smooth_response(a, o, contact);
    friction += std::abs(r.shear * (r.slipped - contact.slip));
    contact.slip = r.slipped;
  }
  a.smooth.write_state(a.intact, a.slip);
}

// As stable_step.cpp does it for the other bonds: row sums of |K|, that of the rotation times the radius.
void add_smooth_stiffness(const Assembly& a, std::vector<double>& row_x, std::vector<double>& row_y,
                          std::vector<double>& row_rotation) {
  for (const auto& c : a.smooth.contacts) {
    const auto i = a.first[c.bond], j = a.second[c.bond];
    const double share = a.thermal.pair_stiffness(i, j) * c.area, kn = a.smooth.normal_stiffness * share,
                 ks = a.smooth.shear_stiffness * share;
    const double nx = std::abs(c.normal.x), ny = std::abs(c.normal.y), both = std::abs(kn - ks) * nx * ny;
    const double opens = std::abs(c.opens_by_first) / a.radius[i] + std::abs(c.opens_by_second) / a.radius[j],
                 slides =
                     std::abs(c.slides_by_first) / a.radius[i] + std::abs(c.slides_by_second) / a.radius[j];
    for (const auto d : {i, j}) {
      const double opens_by = std::abs(d == i ? c.opens_by_first : c.opens_by_second),
                   slides_by = std::abs(d == i ? c.slides_by_first : c.slides_by_second);
      row_x[d] += 2.0 * (kn * nx * nx + ks * ny * ny + both) + kn * nx * opens + ks * ny * slides;
      row_y[d] += 2.0 * (kn * ny * ny + ks * nx * nx + both) + kn * ny * opens + ks * nx * slides;
      row_rotation[d] += a.radius[d] * (2.0 * (kn * opens_by + ks * slides_by) * (nx + ny) +
                                        kn * opens_by * opens + ks * slides_by * slides);
    }
  }
}

}  // namespace hfrac
