// SPDX-License-Identifier: BSD-3-Clause
#include "solid/joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geom/cell_grid.hpp"
#include "solid/discs_held.hpp"
#include "solid/smooth_joints.hpp"

namespace hfrac {
namespace {

// Smooth joints shorter than this many mean radii are no joints of a packing.
constexpr double shortest_smooth = 4.0;

// The last joint that crosses each bond, and the bonds that another one crosses, too. Returns how many joints are too short, or cross none.
std::int64_t find_crossed(const Assembly& a, const std::vector<JointOptions>& joints,
                          std::vector<std::int32_t>& joint_of, std::vector<std::int64_t>& shared) {
  std::vector<double> x, y;
  double longest = 0.0;
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    x.push_back(a.x[a.first[e]] + 0.5 * a.dx(e));
    y.push_back(a.y[a.first[e]] + 0.5 * a.dy(e));
    longest = std::max(longest, a.length(e));
  }
  const CellGrid middles(x, y, longest);
  std::int64_t left_out = 0;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const Vec2 from{joints[k].x1, joints[k].y1}, to{joints[k].x2, joints[k].y2};
    bool found = false;
    const double radius = a.mean_radius_at(0.5 * (from + to));
    if (is_smooth(JointState{joints[k].state}) &&
        dot(to - from, to - from) < shortest_smooth * shortest_smooth * radius * radius) {
      ++left_out;
      continue;
    }
    for (const Vec2 place : places_along(from, to, longest)) {
      middles.near(place.x, place.y, longest, [&](std::int32_t e) {
        const Vec2 first{a.x[a.first[e]], a.y[a.first[e]]}, second{a.x[a.second[e]], a.y[a.second[e]]};
        if (!crosses(from, to, first, second)) return;
        auto& joint = joint_of[static_cast<std::size_t>(e)];
        if (joint >= 0 && joint != static_cast<std::int32_t>(k)) shared.push_back(e);
        joint = static_cast<std::int32_t>(k);
        found = true;
      });
    }
    if (!found) ++left_out;
  }
  return left_out;
}

// Fluid passes such a bond as it passes the nearest contact of the joint.
void bridge_flow(Assembly& a, const std::vector<KeptBond>& kept) {
  const auto& contacts = a.smooth.contacts;
  std::vector<std::vector<std::size_t>> of_joint;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto joint = static_cast<std::size_t>(contacts[k].joint);
    of_joint.resize(std::max(of_joint.size(), joint + 1));
    of_joint[joint].push_back(k);
  }
  for (const auto& [bond, joint] : kept) {
    if (static_cast<std::size_t>(joint) >= of_joint.size()) continue;
    const Vec2 at{a.x[a.first[bond]] + 0.5 * a.dx(bond), a.y[a.first[bond]] + 0.5 * a.dy(bond)};
    std::int32_t nearest = -1;
    double least = 0.0;
    for (const auto k : of_joint[static_cast<std::size_t>(joint)]) {
      const auto i = a.first[contacts[k].bond];
      const Vec2 way = Vec2{a.x[i], a.y[i]} + contacts[k].first_arm() - at;
      if (nearest >= 0 && dot(way, way) >= least) continue;
      nearest = static_cast<std::int32_t>(k);
      least = dot(way, way);
    }
    if (nearest >= 0) a.smooth.bridges.push_back({bond, nearest});
  }
}

}  // namespace

std::int64_t apply_joints(Assembly& a, const std::vector<JointOptions>& joints, const Options& o,
                          CrackLog& log) {
  if (joints.empty()) return 0;
  const auto bonds = static_cast<std::size_t>(a.bond_count());
  std::vector<std::int32_t> joint_of(bonds, -1);
  const std::int64_t left_out = find_crossed(a, joints, joint_of, a.smooth.shared);
  std::sort(a.smooth.shared.begin(), a.smooth.shared.end());
  const HeldDiscs held = keep_discs_held(a, joints, joint_of);
  std::vector<std::int64_t> crossed, broken;
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    const auto joint = joint_of[static_cast<std::size_t>(e)];
    if (joint < 0) continue;
    crossed.push_back(e);
    if (is_broken(JointState{joints[static_cast<std::size_t>(joint)].state})) broken.push_back(e);
  }
  a.joints.index = BondIndex(
      crossed.size(), [&](std::size_t k) { return crossed[k]; }, a.bond_count());
  a.joints.joint.reserve(crossed.size());
  for (const auto e : crossed) a.joints.joint.push_back(joint_of[static_cast<std::size_t>(e)]);
  for (const auto& joint : joints) {
    const Vec2 along{joint.x2 - joint.x1, joint.y2 - joint.y1};
    const double length = norm(along);
    a.joints.normal.push_back({-along.y / length, along.x / length});
  }
  log.reserve_from_start(log.size() + broken.size());
  for (const auto e : broken) {
    a.intact[e] = 0;
    log.push_from_start(e);
  }
  std::vector<std::int32_t> line_of;  // lines are those of smooth joints
  line_of.reserve(joints.size());
  for (const auto& joint : joints)
    line_of.push_back((line_of.empty() ? -1 : line_of.back()) + (is_smooth(JointState{joint.state}) ? 1 : 0));
  for (const auto& [disc, joint] : held.moved)
    a.smooth.moved.push_back({disc, line_of[static_cast<std::size_t>(joint)]});
  begin_smooth_joints(a, joints, joint_of, held.idle, o);
  bridge_flow(a, held.kept);
  combine_factors(a, o);
  return left_out;
}

}  // namespace hfrac
