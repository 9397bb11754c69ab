// SPDX-License-Identifier: BSD-3-Clause
#include "model/network.hpp"

#include <algorithm>
#include <cmath>

#include "options/choices.hpp"

namespace hfrac {
namespace {

// Share of the mean disc's square below which a pore is not taken: slivers between overlapping discs would be stiffer
// than the rock and rule the stable step.
constexpr double smallest_pore = 0.05;

}  // namespace

Network build_network(Faces faces, const Assembly& a, const std::vector<std::int32_t>& well_domain,
                      const Options& options) {
  Network n;
  const std::size_t pipes = a.first.size();
  const auto domains = static_cast<std::size_t>(faces.count());
  n.left = std::move(faces.left);
  n.right = std::move(faces.right);
  const bool wet = FlowScheme{options.flow_scheme} != FlowScheme::off;
  for (auto* values : {&n.aperture, &n.conductance, &n.flow}) values->assign(wet ? pipes : 0, 0.0);
  if (wet && options.fluid_consistency > 0.0) {
    for (std::size_t e = 0; e < pipes; ++e) n.length.push_back(a.pipe_length(static_cast<std::int64_t>(e)));
  }
  for (std::size_t e = 0; e < pipes; ++e) {
    if ((n.left[e] == 0) != (n.right[e] == 0)) n.outer_pipe.push_back(static_cast<std::int32_t>(e));
  }
  n.outer_excess.assign(n.outer_pipe.size(), 0.0);
  for (std::size_t e = 0; wet && a.sizes.graded() && e < pipes; ++e) {
    const double size = a.mean_radius_of(static_cast<std::int64_t>(e)) / a.mean_radius;
    n.pipe_sizes.emplace_back(std::cbrt(size), size);
  }

  n.kind.assign(domains, DomainKind::rock);
  n.kind[0] = DomainKind::outside;
  for (const auto d : well_domain) n.kind[d] = DomainKind::well;
  n.corner_start = std::move(faces.corner_start);
  n.corner_disc = std::move(faces.corner);
  n.centroid = std::move(faces.centroid);
  n.corner_weight.resize(2 * (wet ? n.corner_disc.size() : static_cast<std::size_t>(n.corner_start[1])));
  n.volume.resize(domains);
  double pores = 0.0, rock = 0.0;
  const bool total = StressConvention{options.stress_convention} == StressConvention::total;
  n.reference_pressure = total ? options.fluid_formation_pressure : 0.0;
  n.floor_pressure = total ? 0.0 : -options.fluid_formation_pressure;

  for (std::size_t d = 0; d < domains; ++d) {
    const auto begin = n.corner_start[d], end = n.corner_start[d + 1];
    double sectors = 0.0;
    for (auto k = begin; k < end; ++k) {
      const auto [i, from, to] = n.corner(static_cast<std::int64_t>(d), k);
      const Vec2 centre{a.x[i], a.y[i]};
      const Vec2 back = Vec2{a.x[from], a.y[from]} - centre, ahead = Vec2{a.x[to], a.y[to]} - centre;
      // Chord from the contact behind to the contact ahead; turned clockwise it is the force per pressure (eq. 10).
      const double share_back = a.radius[i] / (a.radius[i] + a.radius[from]);
      const double share_ahead = a.radius[i] / (a.radius[i] + a.radius[to]);
      const Vec2 chord = share_ahead * ahead - share_back * back;
      if (wet || d == 0) {
        const double borne = n.kind[d] == DomainKind::rock ? options.rock_biot_coefficient : 1.0;
        n.corner_weight[2 * k] = borne * chord.y;
        n.corner_weight[2 * k + 1] = -(borne * chord.x);
      }
      sectors += 0.5 * a.radius[i] * a.radius[i] * angle_between(ahead, back);
    }
    const double size = a.mean_radius_at(n.centroid[d]);
    n.volume[d] = std::max(faces.polygon_area[d] - sectors, smallest_pore * size * size);
    if (n.kind[d] != DomainKind::rock) continue;
    pores += n.volume[d];
    rock += faces.polygon_area[d];
  }
  if (options.rock_porosity > 0.0) n.porosity_share = options.rock_porosity * rock / pores;
  const double porosity = n.porosity_share * pores / rock;
  const double grains = options.rock_grain_modulus > 0.0
                            ? (options.rock_biot_coefficient - porosity) / options.rock_grain_modulus
                            : 0.0;
  n.storing.resize(domains);
  for (std::size_t d = 0; d < domains; ++d) {
    const bool is_rock = n.kind[d] == DomainKind::rock;
    if (is_rock) n.volume[d] *= n.porosity_share;
    n.storing[d] = n.volume[d];
    if (is_rock) n.storing[d] += options.fluid_bulk_modulus * std::max(0.0, grains) * faces.polygon_area[d];
  }

  if (wet && FractureAperture{options.flow_fracture_aperture} == FractureAperture::plane)
    n.planes.begin(n, a);
  n.volume_change.assign(domains, 0.0);
  n.content.assign(domains, 0.0);
  n.pressure.assign(domains, n.reference_pressure);
  n.stiffness.assign(domains, 0.0);
  return n;
}

}  // namespace hfrac
