// SPDX-License-Identifier: BSD-3-Clause
#include "host/cell_report.hpp"

#include <cmath>

#include "flow/joint_view.hpp"
#include "frac/fractures.hpp"
#include "model/joint_pores.hpp"

namespace hfrac {

bool carries_fracture_fluid(const Assembly& a, const Network& n, std::size_t pipe) {
  return a.intact[pipe] == 0 || flowing_contact(n, a, pipe) != nullptr;
}

std::vector<char> fractured_pores(const Assembly& a, const Network& n) {
  std::vector<char> fractured(static_cast<std::size_t>(n.domain_count()), 0);
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    if (!carries_fracture_fluid(a, n, e)) continue;
    for (const auto d : {n.left[e], n.right[e]}) {
      if (n.kind[d] == DomainKind::rock) fractured[static_cast<std::size_t>(d)] = 1;
    }
  }
  return fractured;
}

namespace {

// A crack as cells see it: the line it is drawn as or, of a smooth joint, its contact's piece.
struct CellCrack {
  Vec2 begin, end;
  double aperture;    // m, mechanical
  double cube = 0.0;  // m3, w^3 of a joint that conducts
};
CellCrack crack_in_cells(const Assembly& a, const Network& n, const Options& o, std::size_t bond) {
  const auto e = static_cast<std::int64_t>(bond);
  if (const SmoothContact* contact = a.smooth.of(e)) {
    const JointView view = view_joint(a, n, *contact);
    const double w = flowing_contact(n, a, bond) != nullptr ? view.hydraulic_aperture : 0.0;
    return {view.begin, view.end, view.mechanical_aperture, w * w * w};
  }
  const CrackLine line = crack_line(a, o, e);
  const Vec2 half{-0.5 * line.length * line.normal.y, 0.5 * line.length * line.normal.x};
  return {line.middle - half, line.middle + half, line.aperture};
}

}  // namespace

double uniform_gradient_permeability(const Assembly& a, const Network& n, double viscosity) {
  double sum = 0.0, area = 0.0;
  std::vector<Vec2> polygon;
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    const PipeWay way = pipe_way(a, n, e);
    const Vec2 d = way.right - way.left;
    sum += 0.5 * n.conductance_of(e) * dot(d, d);
  }
  for (std::int32_t d = 1; d < n.domain_count(); ++d) {
    if (n.kind[d] != DomainKind::rock) continue;
    polygon.clear();
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k)
      polygon.push_back({a.x[n.corner_disc[k]], a.y[n.corner_disc[k]]});
    area += area_of(polygon);
  }
  return viscosity * sum / area;
}

std::vector<CellReport> report_cells(const HostGrid& grid, const Assembly& a, const Network& n,
                                     const Options& o, Upscaling rule, double oda_matrix) {
  const auto count = static_cast<std::size_t>(grid.count());
  std::vector<CellReport> cells(count);
  const std::vector<char> fractured = fractured_pores(a, n);
  std::vector<double> covered(count, 0.0), rock_area(count, 0.0), pore_volume(count, 0.0), weight(count, 0.0),
      crack_weight(count, 0.0);
  for (std::size_t c = 0; c < count; ++c) cells[c].area = area_of(grid.cell(static_cast<std::int64_t>(c)));

  std::vector<double> shared(fractured.size(), 0.0);  // m2, area of each pore's polygon inside the grid
  for (const auto& part : grid.pores()) shared[static_cast<std::size_t>(part.item)] += part.amount;
  for (const auto& part : grid.pores()) {
    const auto c = static_cast<std::size_t>(part.cell);
    const auto d = static_cast<std::size_t>(part.item);
    covered[c] += part.amount;
    if (n.kind[d] != DomainKind::rock) continue;
    const double volume = (n.volume[d] + n.volume_change[d]) * part.amount / shared[d];
    rock_area[c] += part.amount;
    pore_volume[c] += volume;
    if (fractured[d] != 0 || n.is_well(d)) continue;
    cells[c].pressure += volume * n.pressure[d];
    weight[c] += volume;
  }

  // Pipes: permeability of the uniform gradient, and fluid that leaves cracks through their faces.
  std::vector<double> intact_energy(count, 0.0);
  for (const auto& part : grid.pipes()) {
    const auto e = static_cast<std::size_t>(part.item);
    auto& cell = cells[static_cast<std::size_t>(part.cell)];
    const PipeWay way = pipe_way(a, n, e);
    const Vec2 d = way.right - way.left;
    const double c = part.amount * n.conductance_of(e) * o.fluid_viscosity * n.viscosity_share_of(e);
    const auto l = static_cast<std::size_t>(n.left[e]), r = static_cast<std::size_t>(n.right[e]);
    if (!carries_fracture_fluid(a, n, e)) {
      intact_energy[static_cast<std::size_t>(part.cell)] += 0.5 * c * dot(d, d);
      if (n.kind[l] != DomainKind::rock || n.kind[r] != DomainKind::rock || fractured[l] == fractured[r])
        continue;
      cell.leak_off += part.amount * (fractured[l] != 0 ? n.flow_of(e) : -n.flow_of(e));
    } else if (rule == Upscaling::oda && flowing_contact(n, a, e) == nullptr) {
      cell.permeability[0] += c * d.x * d.x / cell.area;
      cell.permeability[1] += c * d.y * d.y / cell.area;
      cell.permeability[2] += c * d.x * d.y / cell.area;
    }
  }

  // Cracks: length and opening along the line a crack is drawn as.
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    if (a.intact[e] > 0.0) continue;
    const CellCrack crack = crack_in_cells(a, n, o, e);
    double pressure = 0.0, sides = 0.0;
    for (const auto d : {n.left[e], n.right[e]}) {
      if (n.kind[d] == DomainKind::outside) continue;
      pressure += n.pressure[d];
      sides += 1.0;
    }
    const Vec2 way = crack.end - crack.begin;
    const double whole = norm(way);
    grid.along(crack.begin, crack.end, [&](std::int64_t at, double share) {
      auto& cell = cells[static_cast<std::size_t>(at)];
      const double length = share * whole;
      ++cell.crack_count;
      cell.crack_length += length;
      cell.fracture_porosity += length * crack.aperture / cell.area;
      if (rule == Upscaling::oda) {
        const double k = share / whole * crack.cube / (12.0 * cell.area);
        cell.permeability[0] += k * way.x * way.x;
        cell.permeability[1] += k * way.y * way.y;
        cell.permeability[2] += k * way.x * way.y;
      }
      if (sides == 0.0) return;
      // Closed cracks count a little, so that a cell of closed cracks has a pressure too.
      const double opening = length * (crack.aperture + 1e-9 * whole);
      cell.fracture_pressure += opening * pressure / sides;
      crack_weight[static_cast<std::size_t>(at)] += opening;
    });
  }

  for (std::size_t k = 0; k < n.outer_pipe.size(); ++k) {
    const auto e = static_cast<std::size_t>(n.outer_pipe[k]);
    CellReport& cell = cells[static_cast<std::size_t>(grid.outer_cell()[k])];
    cell.outflow += n.left[e] == 0 ? -n.flow_of(e) : n.flow_of(e);
    if (n.left[e] != n.right[e])
      cell.conductance += n.conductance_of(e);  // else it lies outside with both ends
  }

  for (std::size_t c = 0; c < count; ++c) {
    auto& cell = cells[c];
    cell.coverage = std::min(1.0, covered[c] / cell.area);
    cell.pressure = weight[c] > 0.0 ? cell.pressure / weight[c] : n.reference_pressure;
    cell.fracture_pressure = crack_weight[c] > 0.0 ? cell.fracture_pressure / crack_weight[c] : cell.pressure;
    if (rock_area[c] > 0.0) cell.matrix_porosity = pore_volume[c] / rock_area[c];
    if (rule == Upscaling::oda) {
      if (rock_area[c] > 0.0) cell.matrix_permeability = oda_matrix * intact_energy[c] / rock_area[c];
    } else if (rock_area[c] > 0.0) {
      const CellFlow flow =
          flow_through_cell(grid, static_cast<std::int64_t>(c), rock_area[c], a, n, o.fluid_viscosity);
      for (std::size_t k = 0; k < 3; ++k) cell.permeability[k] = flow.fracture[k] * rock_area[c] / cell.area;
      cell.matrix_permeability = flow.matrix;
    }
  }
  return cells;
}

}  // namespace hfrac
