// SPDX-License-Identifier: BSD-3-Clause
#include "solid/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "options/choices.hpp"
#include "solid/toughness.hpp"

namespace hfrac {
Assembly build_assembly(ContactGraph graph, const Options& options) {
  Assembly a;
  a.x = std::move(graph.x);
  a.y = std::move(graph.y);
  a.radius = std::move(graph.radius);
  a.first = std::move(graph.first);
  a.second = std::move(graph.second);
  a.tile_first_bond = std::move(graph.tile_first_edge);
  a.mean_radius = graph.mean_radius;
  a.density = options.disc_density;
  const std::size_t n = a.x.size(), bonds = a.first.size();
  for (auto* values :
       {&a.ux, &a.uy, &a.rotation, &a.vx, &a.vy, &a.spin, &a.external_x, &a.external_y, &a.external_moment})
    values->assign(n, 0.0);

  // Toughness of a bonded assembly goes with strength times sqrt(R) (Potyondy and Cundall 2004): strengths given for
  // one mean radius serve any resolution of the same rock.
  if (options.bond_toughness_reference_radius > 0.0) {
    a.strength_factor = std::sqrt(options.bond_toughness_reference_radius / a.mean_radius);
  }
  a.tensile_per_radius = 2.0 * options.bond_tensile_strength * a.strength_factor;
  a.shear_per_radius = 2.0 * options.bond_shear_strength * a.strength_factor;
  a.geometry.lay_out(a.tile_first_bond, static_cast<std::int64_t>(bonds),
                     GeometryStorage{options.bond_geometry_storage} == GeometryStorage::single_precision);
  a.intact.assign(graph.bonded.begin(), graph.bonded.end());
  a.slip.assign(bonds, 0.0);
  for (std::size_t e = 0; e < bonds; ++e) {
    const auto i = a.first[e], j = a.second[e];
    const double dx = a.x[j] - a.x[i], dy = a.y[j] - a.y[i], length = std::sqrt(dx * dx + dy * dy);
    const auto bond = static_cast<std::int64_t>(e);
    a.geometry.put(a.part_of(bond), bond,
                   {dx, dy, length, length * a.radius[i] / (a.radius[i] + a.radius[j]),
                    options.bond_radius_factor * std::min(a.radius[i], a.radius[j])});
  }
  if (options.bond_fracture_toughness > 0.0) apply_fracture_toughness(a, options);
  return a;
}

std::int64_t Assembly::bond_between(std::int32_t i, std::int32_t j) const {
  if (i > j) std::swap(i, j);
  // Those of a tile and those across tiles are each sorted by (first, second), the former by rank.
  const bool across = i / discs_per_tile != j / discs_per_tile;
  const auto tile = static_cast<std::size_t>(i / discs_per_tile);
  const std::int64_t begin = across ? tile_first_bond.back() : tile_first_bond[tile];
  const std::int64_t count = (across ? bond_count() : tile_first_bond[tile + 1]) - begin;
  const auto place = [&](std::int64_t rank) { return begin + (across ? rank : edge_at(rank, count)); };
  std::int64_t low = 0, high = count;
  while (low < high) {
    const auto middle = low + (high - low) / 2, e = place(middle);
    const bool before = first[e] != i ? first[e] < i : second[e] < j;
    (before ? low : high) = before ? middle + 1 : middle;
  }
  if (low == count) return -1;
  const auto e = place(low);
  return first[e] == i && second[e] == j ? e : -1;
}

BondView view_bond(const Assembly& a, const Options& o, std::int64_t e) {
  if (const SmoothContact* contact = a.smooth.of(e)) return view_smooth(a, o, *contact);
  const auto i = a.first[e], j = a.second[e];
  const Vec2 du{a.ux[j] - a.ux[i], a.uy[j] - a.uy[i]}, d0{a.dx(e), a.dy(e)}, d = d0 + du;
  const double now = std::sqrt(dot(d, d)), length = a.length(e);
  BondView v{};
  v.gap = (2.0 * dot(d0, du) + dot(du, du)) / (now + length) - a.factors.growth_of(e);
  v.normal = (1.0 / now) * d;
  v.first_arm = a.arm(e) * v.normal;
  v.second_arm = (a.arm(e) - length) * v.normal;
  const double sine = cross(d0, du) / now, s2 = sine * sine / (length * length);
  v.shear = sine * (1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0 + s2 * (15.0 / 336.0)))) -
            (a.arm(e) * a.rotation[i] + (length - a.arm(e)) * a.rotation[j]);
  const double bend = a.rotation[j] - a.rotation[i], intact = a.intact[e], r = a.bond_radius(e);
  const double share = a.factors.stiffness_of(e);
  const double bond_normal = o.bond_normal_stiffness * share,
               contact_shear = o.contact_shear_stiffness * share;
  const double bending_stiffness = bond_normal * r * r / 3.0;
  v.bond_normal = bond_normal * intact * v.gap;
  v.bond_shear = o.bond_shear_stiffness * share * intact * v.shear;
  v.bond_moment = bending_stiffness * intact * bend;
  v.bond_energy = 0.5 * (v.bond_normal * v.gap + v.bond_shear * v.shear + v.bond_moment * bend);
  const bool present = intact == 0.0 || ContactMode{o.contact_mode} == ContactMode::parallel;
  v.contact_normal = present ? o.contact_normal_stiffness * share * std::max(0.0, -v.gap) : 0.0;
  const double limit = a.factors.friction_of(e, o.contact_friction) * v.contact_normal;
  v.contact_shear = std::clamp(contact_shear * (v.shear - a.slip[e]), -limit, limit);
  v.contact_energy = 0.5 * v.contact_normal * std::max(0.0, -v.gap);
  if (contact_shear > 0.0) v.contact_energy += 0.5 * v.contact_shear * v.contact_shear / contact_shear;
  const double pull = v.bond_normal + o.bond_moment_contribution * 3.0 * std::abs(v.bond_moment) / r;
  const double tensile = a.tensile_capacity(e), shearing = a.shear_capacity(e);
  v.tensile_excess = tensile > 0.0 ? pull / tensile : (pull >= 0.0 ? 1.0 : 0.0);
  v.shear_excess = shearing > 0.0 ? std::abs(v.bond_shear) / shearing : 1.0;
  return v;
}

}  // namespace hfrac
