// SPDX-License-Identifier: BSD-3-Clause
#include "flow/joint_view.hpp"

#include <algorithm>
#include <cmath>

#include "solid/smooth_joints.hpp"

namespace hfrac {
namespace {

// Of the limit of friction: a contact that slipped in a step stands at its limit but for rounding.
constexpr double used_up = 1.0 - 1e-6;

JointContactState state_of(bool holds, const SmoothResponse& r) {
  if (holds) return JointContactState::holds;
  if (r.normal >= 0.0) return JointContactState::open;
  return std::abs(r.shear) >= used_up * r.shear_limit ? JointContactState::slips : JointContactState::sticks;
}

}  // namespace

JointView view_joint(const Assembly& a, const Network& n, const SmoothContact& contact) {
  const auto e = static_cast<std::size_t>(contact.bond);
  const auto i = a.first[contact.bond], j = a.second[contact.bond];
  const SmoothResponse r = smooth_response(a, contact);
  const Vec2 middle =
      Vec2{a.x[i], a.y[i]} + contact.first_arm() + 0.5 * Vec2{a.ux[i] + a.ux[j], a.uy[i] + a.uy[j]};
  const Vec2 half = 0.5 * contact.area * Vec2{-contact.normal.y, contact.normal.x};
  JointView v{};
  v.begin = middle - half;
  v.end = middle + half;
  v.opening = r.opening;
  v.mechanical_aperture = std::max(0.0, a.smooth.law_of(contact).aperture + r.opening);
  v.hydraulic_aperture = n.aperture_of(e);
  v.total_slip = a.slip[contact.bond];
  v.slip = v.total_slip - a.smooth.counted[a.smooth.place_of(contact)].before;
  v.normal_stress = -r.normal / contact.area;
  v.shear_stress = r.shear / contact.area;
  v.pressure = 0.5 * (n.pressure[n.left[e]] + n.pressure[n.right[e]]);
  v.state = state_of(a.intact[contact.bond] != 0, r);
  return v;
}

}  // namespace hfrac
