// SPDX-License-Identifier: BSD-3-Clause
#include "solid/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <tuple>

#include "options/choices.hpp"

namespace hfrac {

void stiffness_rows(const Assembly& a, const Network& n, const Options& o, const Array<double>* rock_weight,
                    std::span<double> row_x, std::span<double> row_y, std::span<double> row_rotation) {
  const bool facets = rock_weight != nullptr;
  const Array<double>& corner_weight = facets ? *rock_weight : n.corner_weight;
  for (const auto rows : {row_x, row_y, row_rotation}) std::fill(rows.begin(), rows.end(), 0.0);
  const bool parallel = ContactMode{o.contact_mode} == ContactMode::parallel;
  // The stiffer of intact and broken: breakage then never asks for a shorter step.
  const double stiffest_n = parallel ? o.bond_normal_stiffness + o.contact_normal_stiffness
                                     : std::max(o.bond_normal_stiffness, o.contact_normal_stiffness);
  const double stiffest_s = parallel ? o.bond_shear_stiffness + o.contact_shear_stiffness
                                     : std::max(o.bond_shear_stiffness, o.contact_shear_stiffness);
  // A flat contact that is partly open is nowhere stiffer than when all of it is pressed.
  const double stiffest_bending =
      ContactShape{o.contact_shape} == ContactShape::flat ? stiffest_n : o.bond_normal_stiffness;
  for (std::size_t e = 0; e < a.first.size(); ++e) {
    if (a.smooth.of(static_cast<std::int64_t>(e)) != nullptr) continue;  // its contact answers in place of it
    const double share = facets ? 1.0 : a.factors.stiffness_of(static_cast<std::int64_t>(e)),
                 kn = stiffest_n * share, ks = stiffest_s * share;
    double nx = a.dx(e) / a.length(e), ny = a.dy(e) / a.length(e);
    double xx = kn * nx * nx + ks * ny * ny, yy = kn * ny * ny + ks * nx * nx,
           xy = std::abs((kn - ks) * nx * ny);
    if (facets) {  // the largest that xx + xy, |nx| + |ny| and |nx| get
      xx = yy = 0.5 * (kn + ks);
      xy = std::abs(kn - ks) * std::numbers::sqrt2 / 2.0;
      nx = ny = 1.0;
    }
    const auto i = a.first[e], j = a.second[e];
    const double arm_i = a.arm(e), arm_j = a.length(e) - a.arm(e);
    const double lever = arm_i / a.radius[i] + arm_j / a.radius[j];
    const double bending = stiffest_bending * share * a.bond_radius(e) * a.bond_radius(e) / 3.0;
    for (const auto& [d, arm, other] : {std::tuple{i, arm_i, j}, std::tuple{j, arm_j, i}}) {
      row_x[d] += 2.0 * (xx + xy) + ks * std::abs(ny) * lever;
      row_y[d] += 2.0 * (yy + xy) + ks * std::abs(nx) * lever;
      // times radius: the row belongs to rotation * radius, and inertia / radius^2 is its mass.
      row_rotation[d] += a.radius[d] * (2.0 * ks * arm * (std::abs(nx) + std::abs(ny)) + ks * arm * lever +
                                        bending * (1.0 / a.radius[d] + 1.0 / a.radius[other]));
    }
  }
  if (FlowScheme{o.flow_scheme} == FlowScheme::off) return;
  for (std::int64_t d = 1; d < n.domain_count(); ++d) {
    if (n.kind[d] == DomainKind::outside) continue;
    double weight = 0.0;
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
      weight += std::abs(corner_weight[2 * k]) + std::abs(corner_weight[2 * k + 1]);
      if (!n.corner_turn.empty()) weight += std::abs(n.corner_turn[k]) / a.radius[n.corner_disc[k]];
    }
    const double per_weight = weight * o.fluid_bulk_modulus / n.least_storing(d);
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
      row_x[n.corner_disc[k]] += std::abs(corner_weight[2 * k]) * per_weight;
      row_y[n.corner_disc[k]] += std::abs(corner_weight[2 * k + 1]) * per_weight;
      if (!n.corner_turn.empty())
        row_rotation[n.corner_disc[k]] +=
            a.radius[n.corner_disc[k]] * std::abs(n.corner_turn[k]) * per_weight;
    }
  }
}

}  // namespace hfrac
