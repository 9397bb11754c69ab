// SPDX-License-Identifier: BSD-3-Clause
// What a reservoir simulator puts into a simulation, by cell of its grid: pressure of the rock, pressure beyond the outer boundary,
// stress. What it takes out is host/cell_report.cpp.
//
// Whose fluid is whose. The pores of the model are the simulation's; the host's are what lies outside. Fluid passes in two
// ways, each with an entry of its own in the balance:
//   leaked   through the outer boundary's pipes, driven by the pressure the host sets beyond them
//   host     put into (or out of) pores when the host sets their pressure
// injected + host = stored + leaked holds to rounding whatever the host does.
#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "couple/simulation.hpp"
#include "options/choices.hpp"

namespace hfrac {
namespace {

std::string cell_name(const HostGrid& grid, std::size_t c) {
  const auto at = static_cast<std::int64_t>(c);
  return "cell (" + std::to_string(at % grid.nx()) + ", " + std::to_string(at / grid.nx()) + ")";
}

}  // namespace

void Simulation::set_grid(HostGrid grid) {
  grid.lay_over(assembly_, network_);
  grid_ = std::move(grid);
}

const HostGrid& Simulation::grid() const {
  if (!grid_)
    throw Error(ErrorKind::argument, "this simulation has no host grid; call hfrac_set_grid first.");
  return *grid_;
}

void Simulation::require_cells(std::size_t given, std::size_t per_cell, const char* what) const {
  const auto cells = static_cast<std::size_t>(grid().count());
  if (given == per_cell * cells) return;
  throw Error(ErrorKind::argument, std::string(what) + " has " + std::to_string(given) +
                                       " values; the grid has " + std::to_string(cells) + " cells, so " +
                                       std::to_string(per_cell * cells) + " are needed.");
}

std::vector<CellReport> Simulation::cells(Upscaling rule) const {
  return report_cells(grid(), assembly_, network_, options(), rule, oda_matrix_);
}

void Simulation::set_cell_pressure(std::span<const double> pressure, std::span<double> added) {
  require_cells(pressure.size(), 1, "pressure");
  if (!flow_)
    throw Error(ErrorKind::argument, "flow.scheme is \"off\", so pores have no pressure of their own.");
  if (step_open_) {
    throw Error(ErrorKind::argument,
                "a step is open, and tries start from where it was opened; set pores' pressures before "
                "hfrac_step_prepare.");
  }
  const auto count = static_cast<std::size_t>(network_.domain_count());
  std::vector<double> sum(count, 0.0), area(count, 0.0), gain(count, 0.0);
  for (const auto& part : grid_->pores()) {
    const auto d = static_cast<std::size_t>(part.item), c = static_cast<std::size_t>(part.cell);
    const double p = pressure[c];
    if (!std::isfinite(p) || p < network_.floor_pressure) {
      throw Error(ErrorKind::argument, "pressure of " + cell_name(*grid_, c) + " is " + std::to_string(p) +
                                           " Pa; it must be finite and at least " +
                                           std::to_string(network_.floor_pressure) + " Pa.");
    }
    sum[d] += part.amount * p;
    area[d] += part.amount;
  }
  const std::vector<char> fractured = fractured_pores(assembly_, network_);
  for (std::size_t d = 1; d < count; ++d) {
    if (network_.kind[d] != DomainKind::rock || fractured[d] != 0 || area[d] <= 0.0) continue;
    const double p = sum[d] / area[d];
    const double content =
        content_at(network_, static_cast<std::int64_t>(d), options().fluid_bulk_modulus, p);
    gain[d] = content - network_.content[d];
    network_.content[d] = content;
    network_.pressure[d] = p;
    host_added_ += gain[d];
    book_host_fluid(d, gain[d]);
  }
  if (added.empty()) return;
  std::fill(added.begin(), added.end(), 0.0);
  for (const auto& part : grid_->pores()) {
    const auto d = static_cast<std::size_t>(part.item);
    if (gain[d] != 0.0) added[static_cast<std::size_t>(part.cell)] += gain[d] * part.amount / area[d];
  }
}

void Simulation::set_boundary_pressure(std::span<const double> pressure) {
  if (!flow_ || OuterPores{options().flow_outer} == OuterPores::closed) {
    throw Error(ErrorKind::argument,
                "no fluid passes this model's outer boundary; it takes flow.outer = \"formation\" and a "
                "flow.scheme other than "
                "\"off\".");
  }
  if (pressure.empty()) {  // taken back: the same all around again
    std::fill(network_.outer_excess.begin(), network_.outer_excess.end(), 0.0);
    outer_is_hosts_ = false;
    return;
  }
  require_cells(pressure.size(), 1, "pressure");
  const auto& cell = grid_->outer_cell();
  for (const auto c : cell) {
    const double p = pressure[static_cast<std::size_t>(c)];
    if (std::isfinite(p) && p >= network_.floor_pressure) continue;
    throw Error(ErrorKind::argument,
                "pressure of " + cell_name(*grid_, static_cast<std::size_t>(c)) + " is " + std::to_string(p) +
                    " Pa; at the model's outer boundary it must be finite and at least " +
                    std::to_string(network_.floor_pressure) + " Pa.");
  }
  for (std::size_t k = 0; k < cell.size(); ++k)
    network_.outer_excess[k] = pressure[static_cast<std::size_t>(cell[k])] - network_.pressure[0];
  outer_is_hosts_ = true;
}

void Simulation::set_cell_stress(std::span<const double> stress) {
  require_cells(stress.size(), 3, "stress");
  if (boundary_->walled()) {
    throw Error(ErrorKind::argument,
                "walls are straight and cannot carry a stress that changes along them; use boundary.kind = "
                "\"stress\".");
  }
  std::vector<double> loop;
  for (const auto c : grid_->loop_cell()) {
    for (std::size_t k = 0; k < 3; ++k) {
      loop.push_back(stress[3 * static_cast<std::size_t>(c) + k]);
      if (std::isfinite(loop.back())) continue;
      throw Error(ErrorKind::argument,
                  "stress of " + cell_name(*grid_, static_cast<std::size_t>(c)) + " is not a finite number.");
    }
  }
  boundary_->set_host_stress(assembly_, network_, loop, options().stress_sigma_Hmax,
                             options().stress_sigma_hmin);
}

}  // namespace hfrac
