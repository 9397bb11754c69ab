// SPDX-License-Identifier: BSD-3-Clause
#include "frac/facets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/joint_pores.hpp"

namespace hfrac {
namespace {

constexpr double long_ago = -1e30;  // s

// What a bond and its contact pull their first disc with, as in the equations of equilibrium (bond_response.cpp).
Vec2 force_on_first(const Assembly& a, std::int64_t e, const BondView& v) {
  const auto i = a.first[e], j = a.second[e];
  const Vec2 now{a.dx(e) + a.ux[j] - a.ux[i], a.dy(e) + a.uy[j] - a.uy[i]};
  const double turn = a.smooth.of(e) != nullptr ? 1.0 : a.length(e) / norm(now);
  return v.normal_force() * v.normal + turn * v.shear_force() * Vec2{-v.normal.y, v.normal.x};
}
}  // namespace

// From the contact into the pore on one side, turned so that it points towards the second disc.
Vec2 Facets::part(std::int64_t e, bool left) const {
  const auto d = left ? network_->left[e] : network_->right[e];
  if (network_->kind[d] != DomainKind::rock) return {};
  const Vec2 way = network_->centroid[d] - contact_[e];
  return left ? clockwise(way) : -1.0 * clockwise(way);
}

// What a pore pushes on the first disc of a bond, per pressure [m]: over the chord from the contact; the fluid in a joint that conducts
// pushes on the faces of its contacts alone (model/joint_pores.hpp).
Vec2 Facets::pushed(std::int64_t e, bool left) const {
  const auto d = left ? network_->left[e] : network_->right[e];
  if (!in_joint(d)) return part(e, left);
  const SmoothContact* contact = assembly_->smooth.of(e);
  const bool conducts = contact != nullptr && joint_length(*network_, static_cast<std::size_t>(e)) > 0.0;
  return conducts ? 0.5 * contact->area * contact->normal : Vec2{};
}

void Facets::begin(const Assembly& a, Network& n, const std::vector<WellPlace>& wells, const Options& o) {
  plate_ = {o.stress_sigma_Hmax, o.stress_sigma_hmin, {}};
  for (const auto& well : wells)
    plate_.holes.push_back({well.centre, well.equivalent_radius, n.pressure[well.domain], well.domain});
  active_ = true;
  assembly_ = &a;
  network_ = &n;
  start_.stiffness = o.contact_normal_stiffness;
  const auto bonds = a.first.size();
  start_.x = a.ux;
  start_.y = a.uy;
  start_.rotation = a.rotation;
  of_.assign(bonds, -1);
  cut_.assign(bonds, 0);
  fractured_.assign(n.kind.size(), 0);
  bonds_.assign(n.kind.size(), {});
  n.facet_offset.assign(n.kind.size(), 0.0);
  for (auto* values : {&n.facet_opening, &n.facet_way, &n.facet_least}) values->assign(bonds, 0.0);
  n.facet_time.assign(bonds, long_ago);
  biot_ = o.rock_biot_coefficient;
  pressure_.assign(n.pressure.begin(), n.pressure.end());
  for (std::size_t d = 0; d < pressure_.size(); ++d)
    if (n.kind[d] == DomainKind::rock && !in_joint(static_cast<std::int32_t>(d))) pressure_[d] *= biot_;
  pore_push_.assign(2 * bonds, 0.0);
  weight_ = n.corner_weight;
  turn_ = n.corner_turn;
  force_.assign(4 * bonds, 0.0);
  energy_.assign(bonds, 0.0);
  contact_.resize(bonds);
  const auto discs = static_cast<std::size_t>(a.disc_count());
  Array<double> area;
  area.assign(discs, 0.0);
  for (std::size_t e = 0; e < bonds; ++e) {
    const auto i = a.first[e], j = a.second[e];
    const auto b = static_cast<std::int64_t>(e);
    const BondView v = view_bond(a, o, b);
    const Vec2 d = (1.0 / a.length(b)) * Vec2{a.dx(b), a.dy(b)};
    contact_[e] = Vec2{a.x[i], a.y[i]} + a.arm(b) * d;
    bonds_[n.left[e]].push_back(static_cast<std::int32_t>(e));
    if (n.right[e] != n.left[e]) bonds_[n.right[e]].push_back(static_cast<std::int32_t>(e));
    energy_[e] = v.bond_energy + v.contact_energy;
    const Vec2 f = force_on_first(a, b, v);
    const double arm_i = a.arm(b), arm_j = a.length(b) - arm_i;
    force_[4 * e] = f.x;
    force_[4 * e + 1] = f.y;
    force_[4 * e + 2] = -(v.shear_force() * arm_i + v.bond_moment);
    force_[4 * e + 3] = -(v.shear_force() * arm_j - v.bond_moment);
    const Vec2 h_l = part(b, true), h_r = part(b, false);
    // Love's mean over a disc and its share of the pores: forces times their arms over the area out to the facets.
    const double facet = std::abs(dot(h_l + h_r, d));
    area[i] += 0.5 * arm_i * facet;
    area[j] += 0.5 * arm_j * facet;
  }
  area_ = area;
  disc_bonds_.assign(discs, {});
  for (std::size_t e = 0; e < bonds; ++e) {
    disc_bonds_[a.first[e]].push_back(static_cast<std::int32_t>(e));
    disc_bonds_[a.second[e]].push_back(static_cast<std::int32_t>(e));
  }
}

void Facets::stress_around(const Assembly& a, const Network& n, const Options& o, std::int32_t domain,
                           double* stress) const {
  std::vector<std::int32_t> discs;
  const auto add = [&](std::int32_t i) {
    if (std::find(discs.begin(), discs.end(), i) == discs.end()) discs.push_back(i);
  };
  for (auto k = n.corner_start[domain]; k < n.corner_start[domain + 1]; ++k) add(n.corner_disc[k]);
  const auto ring = discs;
  for (const auto i : ring)
    for (const auto e : disc_bonds_[i])
      if (a.intact[e] != 0) {
        add(a.first[e]);
        add(a.second[e]);
      }
  double area = 0.0;
  stress[0] = stress[1] = stress[2] = 0.0;
  for (const auto i : discs) {
    area += area_[i];
    const auto initial = plate_.at({a.x[i], a.y[i]});
    stress[0] += area_[i] * initial.xx;
    stress[1] += area_[i] * initial.yy;
    stress[2] += area_[i] * initial.xy;
    for (const auto e : disc_bonds_[i]) {
      const Vec2 d = (1.0 / a.length(e)) * Vec2{a.dx(e), a.dy(e)};
      const Vec2 h_l = pushed(e, true), h_r = pushed(e, false);
      const SmoothContact* joint = a.smooth.of(e);
      // Force on the first disc now less that at the initial equilibrium, fluid included.
      Vec2 now;
      if (of_[e] >= 0) {
        const Facet& f = facets_[of_[e]];
        const double push = n.pressure[f.left] * f.left_length + n.pressure[f.right] * f.right_length;
        const double w = opening(a, n, f);
        now = (w >= 0.0 ? -push : start_.stiffness * jump(a, f, f.normal) - f.initial_normal) * f.normal +
              f.locked;
      } else {
        const auto borne = [&](std::int32_t pore) {
          if (in_joint(pore)) return n.pressure[pore];
          return fractured_[pore] ? pressure_[pore] : biot_ * n.pressure[pore];
        };
        now = force_on_first(a, e, view_bond(a, o, e)) - (borne(n.left[e]) * h_l + borne(n.right[e]) * h_r);
      }
      const Vec2 before = initial_force(e) - (pressure_[n.left[e]] * h_l + pressure_[n.right[e]] * h_r);
      Vec2 more = now - before;
      const bool is_first = a.first[e] == i;
      Vec2 arm = is_first ? a.arm(e) * d : (a.arm(e) - a.length(e)) * d;
      if (joint != nullptr) arm = is_first ? joint->first_arm() : joint->second_arm();
      if (!is_first) more = -1.0 * more;
      stress[0] -= arm.x * more.x;
      stress[1] -= arm.y * more.y;
      stress[2] -= 0.5 * (arm.x * more.y + arm.y * more.x);
    }
  }
  for (int k = 0; k < 3; ++k) stress[k] /= area;
}

double Facets::opening(const Assembly& a, const Network& n, const Facet& f) const {
  const double push = n.pressure[f.left] * f.left_length + n.pressure[f.right] * f.right_length;
  return facet_opening(a, start_, f, push);
}

double Facets::energy(const Assembly& a, const Network& n, const Options& o) const {
  if (!active_) return 0.0;
  double energy = -n.facet_pushed;
  // In motion by the pressures up to which work is counted; fluid that flowed since has not moved the rock.
  const Array<double>& pressure = n.facet_worked.empty() ? n.pressure : n.facet_worked;
  for (const Facet& f : facets_) {
    const auto at = [&](std::int32_t d) {
      return n.kind[d] == DomainKind::rock ? pressure[d] : n.pressure[d];
    };
    energy += facet_energy(a, o, start_, f, at(f.left) * f.left_length + at(f.right) * f.right_length);
  }
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    const Vec2 force = locked_of(e);
    if (force.x != 0.0 || force.y != 0.0) energy += push_energy(a, start_, e, force);
  }
  return energy;
}

void Facets::tell_openings(const Assembly& a, Network& n) const {
  for (const Facet& f : facets_) n.facet_opening[f.bond] = std::max(0.0, jump(a, f, f.normal));
}

}  // namespace hfrac
