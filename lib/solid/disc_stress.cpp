// SPDX-License-Identifier: BSD-3-Clause
#include "solid/disc_stress.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include "solid/bond_law.hpp"
#include "solid/boundary.hpp"

namespace hfrac {

void find_disc_stress(const Model& m, const Options& o, double* to) {
  const Assembly& a = m.assembly;
  const auto discs = static_cast<std::size_t>(a.disc_count());
  std::fill(to, to + 3 * discs, 0.0);
  const auto add = [&](std::size_t disc, Vec2 force, Vec2 arm) {
    to[3 * disc] -= force.x * arm.x;
    to[3 * disc + 1] -= force.y * arm.y;
    to[3 * disc + 2] -= 0.5 * (force.x * arm.y + force.y * arm.x);
  };
  for (std::size_t e = 0; e < a.first.size(); ++e) {
    const BondView bond = view_bond(a, o, static_cast<std::int64_t>(e));
    const Vec2 tangent{-bond.normal.y, bond.normal.x};
    const Vec2 on_first = bond.normal_force() * bond.normal + bond.shear_force() * tangent;
    const auto i = static_cast<std::size_t>(a.first[e]), j = static_cast<std::size_t>(a.second[e]);
    add(i, on_first, bond.first_arm);
    add(j, -1.0 * on_first, bond.second_arm);
  }
  for (const auto& wall : m.boundary.walls) {
    for (const auto i : wall.discs) {
      const double force = Boundary::push_of(a, wall, i, o.contact_normal_stiffness);
      add(static_cast<std::size_t>(i), force * wall.inward, -a.radius[i] * wall.inward);
    }
  }
  std::vector<double> cell(discs);
  for (std::size_t i = 0; i < discs; ++i) cell[i] = std::numbers::pi * a.radius[i] * a.radius[i];
  const Network& n = m.network;
  for (std::size_t d = 1; d < n.kind.size(); ++d) {
    if (n.kind[d] != DomainKind::rock) continue;
    const auto begin = n.corner_start[d], end = n.corner_start[d + 1];
    for (auto k = begin; k < end; ++k)
      cell[static_cast<std::size_t>(n.corner_disc[k])] += n.volume[d] / n.porosity_share / (end - begin);
  }
  for (std::size_t i = 0; i < discs; ++i) {
    for (std::size_t k = 0; k < 3; ++k) to[3 * i + k] /= cell[i];
  }
}

}  // namespace hfrac
