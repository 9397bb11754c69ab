// SPDX-License-Identifier: BSD-3-Clause
#include "frac/joint_stress.hpp"

#include "frac/holed_plate.hpp"

namespace hfrac {
namespace {

Vec2 place_of(const Assembly& a, const SmoothContact& c) {
  const auto i = a.first[c.bond];
  return Vec2{a.x[i], a.y[i]} + c.first_arm();
}

std::vector<JointStress> mean_along(const Assembly& a) {
  constexpr double reach = 4.0;  // mean radii to either side
  const auto& contacts = a.smooth.contacts;
  std::vector<std::vector<std::size_t>> on(a.smooth.law_number.size());
  for (std::size_t k = 0; k < contacts.size(); ++k)
    on[static_cast<std::size_t>(contacts[k].joint)].push_back(k);
  std::vector<JointStress> bears, mean(contacts.size());  // N; Pa
  for (const auto& contact : contacts) {
    // The slide keeps its sign whichever disc is the first: it and its direction turn together.
    const SmoothResponse r = smooth_response(a, contact);
    bears.push_back({-r.normal, r.shear});
  }
  for (const auto& joint : on)
    for (const auto k : joint) {
      double area = 0.0;
      const double radius = a.mean_radius_at(place_of(a, contacts[k]));
      for (const auto other : joint) {
        const Vec2 way = place_of(a, contacts[other]) - place_of(a, contacts[k]);
        if (dot(way, way) > reach * reach * radius * radius) continue;
        mean[k].normal += bears[other].normal;
        mean[k].shear += bears[other].shear;
        area += contacts[other].area;
      }
      mean[k] = {mean[k].normal / area, mean[k].shear / area};
    }
  return mean;
}

}  // namespace

std::vector<JointStress> stress_on_joints(const Model& m, const Options& o, bool walled) {
  const Assembly& a = m.assembly;
  if (walled) return mean_along(a);
  const auto& p = m.network.pressure;
  HoledPlate plate{o.stress_sigma_Hmax, o.stress_sigma_hmin, {}};
  for (const auto& well : m.wells)
    plate.holes.push_back(
        {well.place.centre, well.place.equivalent_radius, p[well.place.domain], well.place.domain});
  std::vector<JointStress> stress;
  for (const auto& c : a.smooth.contacts) {
    const auto s = plate.at(place_of(a, c));
    const Vec2 n = c.normal, along{-n.y, n.x}, push{s.xx * n.x + s.xy * n.y, s.xy * n.x + s.yy * n.y};
    const double inside = 0.5 * (p[m.network.left[c.bond]] + p[m.network.right[c.bond]]);
    stress.push_back({dot(push, n) - inside, -dot(push, along)});
  }
  return stress;
}

}  // namespace hfrac
