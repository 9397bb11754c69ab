// SPDX-License-Identifier: BSD-3-Clause
#include "solid/assembly.hpp"

#include <algorithm>
#include <cmath>

#include "options/choices.hpp"

namespace hfrac {
namespace {

constexpr double pi = 3.14159265358979323846;

void build_incidence(Assembly& a) {
  const auto n = static_cast<std::size_t>(a.disc_count());
  a.incidence_start.assign(n + 1, 0);
  for (std::size_t e = 0; e < a.first.size(); ++e) {
    ++a.incidence_start[a.first[e] + 1];
    ++a.incidence_start[a.second[e] + 1];
  }
  for (std::size_t i = 0; i < n; ++i) a.incidence_start[i + 1] += a.incidence_start[i];
  a.incidence.resize(2 * a.first.size());
  auto cursor = a.incidence_start;
  for (std::size_t e = 0; e < a.first.size(); ++e) {
    a.incidence[cursor[a.first[e]]++] = static_cast<std::int32_t>(2 * e);
    a.incidence[cursor[a.second[e]]++] = static_cast<std::int32_t>(2 * e + 1);
  }
}

}  // namespace

Assembly build_assembly(const ContactGraph& graph, const Options& options) {
  Assembly a;
  a.x = graph.x;
  a.y = graph.y;
  a.radius = graph.radius;
  a.mean_radius = graph.mean_radius;
  const std::size_t n = a.x.size(), bonds = graph.first.size();
  for (auto* values :
       {&a.ux, &a.uy, &a.rotation, &a.vx, &a.vy, &a.spin, &a.external_x, &a.external_y, &a.external_moment})
    values->assign(n, 0.0);
  a.mass.resize(n);
  a.inertia.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    a.mass[i] = options.disc_density * pi * a.radius[i] * a.radius[i];
    a.inertia[i] = 0.5 * a.mass[i] * a.radius[i] * a.radius[i];  // a cylinder about its axis
  }

  // Toughness of a bonded assembly goes with strength times sqrt(R) (Potyondy and Cundall 2004): strengths given for
  // one mean radius serve any resolution of the same rock.
  if (options.bond_toughness_reference_radius > 0.0) {
    a.strength_factor = std::sqrt(options.bond_toughness_reference_radius / a.mean_radius);
  }
  a.first = graph.first;
  a.second = graph.second;
  for (auto* values :
       {&a.dx, &a.dy, &a.length, &a.arm, &a.bond_radius, &a.tensile_capacity, &a.shear_capacity})
    values->resize(bonds);
  a.intact.assign(bonds, 1.0);
  a.slip.assign(bonds, 0.0);
  a.force.assign(bonds, BondForce{0.0, 0.0, 0.0, 0.0});
  for (std::size_t e = 0; e < bonds; ++e) {
    const auto i = a.first[e], j = a.second[e];
    a.dx[e] = a.x[j] - a.x[i];
    a.dy[e] = a.y[j] - a.y[i];
    a.length[e] = std::sqrt(a.dx[e] * a.dx[e] + a.dy[e] * a.dy[e]);
    a.arm[e] = a.length[e] * a.radius[i] / (a.radius[i] + a.radius[j]);
    a.bond_radius[e] = options.bond_radius_factor * std::min(a.radius[i], a.radius[j]);
    const double area = 2.0 * a.bond_radius[e];  // unit thickness
    a.tensile_capacity[e] = options.bond_tensile_strength * a.strength_factor * area;
    a.shear_capacity[e] = options.bond_shear_strength * a.strength_factor * area;
  }
  build_incidence(a);
  return a;
}

BondView view_bond(const Assembly& a, const Options& o, std::int64_t e) {
  const auto i = a.first[e], j = a.second[e];
  const Vec2 du{a.ux[j] - a.ux[i], a.uy[j] - a.uy[i]}, d0{a.dx[e], a.dy[e]}, d = d0 + du;
  const double now = std::sqrt(dot(d, d)), length = a.length[e];
  BondView v{};
  v.gap = (2.0 * dot(d0, du) + dot(du, du)) / (now + length);
  v.normal = (1.0 / now) * d;
  const double sine = cross(d0, du) / now, s2 = sine * sine / (length * length);
  v.shear = sine * (1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0 + s2 * (15.0 / 336.0)))) -
            (a.arm[e] * a.rotation[i] + (length - a.arm[e]) * a.rotation[j]);
  const double bend = a.rotation[j] - a.rotation[i], intact = a.intact[e], r = a.bond_radius[e];
  const double bending_stiffness = o.bond_normal_stiffness * r * r / 3.0;
  v.bond_normal = o.bond_normal_stiffness * intact * v.gap;
  v.bond_shear = o.bond_shear_stiffness * intact * v.shear;
  v.bond_moment = bending_stiffness * intact * bend;
  v.bond_energy = 0.5 * (v.bond_normal * v.gap + v.bond_shear * v.shear + v.bond_moment * bend);
  const bool present = intact == 0.0 || ContactMode{o.contact_mode} == ContactMode::parallel;
  v.contact_normal = present ? o.contact_normal_stiffness * std::max(0.0, -v.gap) : 0.0;
  const double limit = o.contact_friction * v.contact_normal;
  v.contact_shear = std::clamp(o.contact_shear_stiffness * (v.shear - a.slip[e]), -limit, limit);
  v.contact_energy = 0.5 * v.contact_normal * std::max(0.0, -v.gap);
  if (o.contact_shear_stiffness > 0.0)
    v.contact_energy += 0.5 * v.contact_shear * v.contact_shear / o.contact_shear_stiffness;
  const double pull = v.bond_normal + o.bond_moment_contribution * 3.0 * std::abs(v.bond_moment) / r;
  v.tensile_excess = a.tensile_capacity[e] > 0.0 ? pull / a.tensile_capacity[e] : (pull >= 0.0 ? 1.0 : 0.0);
  v.shear_excess = a.shear_capacity[e] > 0.0 ? std::abs(v.bond_shear) / a.shear_capacity[e] : 1.0;
  return v;
}

}  // namespace hfrac
