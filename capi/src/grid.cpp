// SPDX-License-Identifier: BSD-3-Clause
// A host's grid from C: laying it over the model, reading its cells, putting values in.
#include "hfrac/grid.h"

#include <algorithm>
#include <string>

#include "grdecl.hpp"
#include "internal.hpp"
#include "sim_handle.hpp"
#include "step/host_state.hpp"
#include "step/impose.hpp"
#include "step/simulation.hpp"
#include "stepping.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

Upscaling upscaling_of(std::int32_t method) {
  if (method != HFRAC_UPSCALE_ODA && method != HFRAC_UPSCALE_FLOW) {
    throw Error(ErrorKind::argument, "method = " + std::to_string(method) +
                                         " is no upscaling rule; give HFRAC_UPSCALE_ODA (0) or "
                                         "HFRAC_UPSCALE_FLOW (1).");
  }
  return Upscaling{method};
}

hfrac_cell describe(const CellReport& from) {
  hfrac_cell to{};
  to.area = from.area;
  to.coverage = from.coverage;
  std::copy(from.permeability, from.permeability + 3, to.permeability);
  to.matrix_permeability = from.matrix_permeability;
  to.fracture_porosity = from.fracture_porosity;
  to.matrix_porosity = from.matrix_porosity;
  to.crack_length = from.crack_length;
  to.leak_off = from.leak_off;
  to.outflow = from.outflow;
  to.conductance = from.conductance;
  to.pressure = from.pressure;
  to.fracture_pressure = from.fracture_pressure;
  to.crack_count = from.crack_count;
  return to;
}

std::span<const double> values_of(const double* values, std::int64_t count, const char* name) {
  require_not_null(values, name);
  if (count < 0) throw Error(ErrorKind::argument, "count = " + std::to_string(count) + " is negative.");
  return {values, static_cast<std::size_t>(count)};
}

}  // namespace

int32_t hfrac_set_grid(hfrac_sim* sim, const hfrac_grid* grid) {
  return guarded_sim(sim, [&] {
    const hfrac_grid full = read_struct(grid, hfrac_grid{}, "hfrac_grid");
    if (full.corners == nullptr) {
      sim->simulation->set_grid(HostGrid::regular(full.nx, full.ny, {full.origin[0], full.origin[1]},
                                                  {full.dx, full.dy}, full.angle));
    } else {
      sim->simulation->set_grid(HostGrid::from_corners(full.nx, full.ny, full.corners));
    }
    ++sim->epoch;
  });
}

int32_t hfrac_grid_cells(hfrac_sim* sim, int32_t method, int32_t cell_size, hfrac_cell* buffer,
                         int64_t capacity, int64_t* count) {
  return guarded_sim(sim, Access::read, [&] {
    const Upscaling rule = upscaling_of(method);
    require_not_null(count, "count");
    require_grid(*sim);
    const std::int64_t there = sim->simulation->grid().count();
    *count = there;
    if (buffer == nullptr) return;
    require_struct_size(cell_size, "hfrac_cell");
    const std::vector<CellReport> cells = report_cells(*sim->simulation, rule);
    const auto stride = static_cast<std::size_t>(cell_size);
    auto* to = reinterpret_cast<unsigned char*>(buffer);
    for (std::int64_t c = 0; c < std::min(there, capacity); ++c) {
      const hfrac_cell cell = describe(cells[static_cast<std::size_t>(c)]);
      std::memset(to, 0, stride);
      std::memcpy(to, &cell, std::min(stride, sizeof cell));
      to += stride;
    }
  });
}

int32_t hfrac_set_boundary_pressure(hfrac_sim* sim, const double* pressure, int64_t count) {
  return guarded_sim(sim, [&] {
    const bool back = count == 0;
    set_boundary_pressure(*sim->simulation,
                          back ? std::span<const double>() : values_of(pressure, count, "pressure"));
    ++sim->epoch;
  });
}

int32_t hfrac_set_cell_pressure(hfrac_sim* sim, const double* pressure, int64_t count, double* added,
                                int64_t capacity) {
  return guarded_sim(sim, [&] {
    const auto given = values_of(pressure, count, "pressure");
    std::span<double> taken;
    if (added != nullptr) {
      if (capacity < count) {
        throw Error(ErrorKind::argument, "capacity = " + std::to_string(capacity) +
                                             " of added is less than the " + std::to_string(count) +
                                             " cells.");
      }
      taken = {added, given.size()};
    }
    require_grid(*sim);
    require_not_between_tries(*sim, "the pressures of pores");
    set_cell_pressure(*sim->simulation, given, taken);
    ++sim->epoch;
  });
}

int32_t hfrac_set_cell_stress(hfrac_sim* sim, const double* stress, int64_t count) {
  return guarded_sim(sim, [&] {
    require_grid(*sim);
    set_cell_stress(*sim->simulation, values_of(stress, count, "stress"));
    ++sim->epoch;
  });
}

int32_t hfrac_write_grdecl(hfrac_sim* sim, const char* path, int32_t method, int32_t kind, int64_t layers,
                           double porosity, double permeability) {
  return guarded_sim(sim, Access::read, [&] {
    require_not_null(path, "path");
    const Upscaling rule = upscaling_of(method);
    require_grid(*sim);
    write_grdecl(*sim->simulation, path, rule, {kind, layers, porosity, permeability});
  });
}
