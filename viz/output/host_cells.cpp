// SPDX-License-Identifier: BSD-3-Clause
#include "output/host_cells.hpp"

#include <algorithm>
#include <cmath>

#include "output/tables.hpp"
#include "run/files.hpp"

namespace hfrac::output {

void lay_grid(hfrac_sim* sim, const std::vector<double>& numbers) {
  auto grid = sized<hfrac_grid>();
  grid.nx = std::llround(numbers[0]);
  grid.ny = std::llround(numbers[1]);
  grid.dx = numbers[2];
  grid.dy = numbers[3];
  if (numbers.size() > 6) grid.angle = numbers[6] * 3.14159265358979323846 / 180.0;
  if (numbers.size() > 5) {
    grid.origin[0] = numbers[4];
    grid.origin[1] = numbers[5];
  } else {
    const auto definition = definition_of(sim);
    grid.origin[0] = 0.5 * (definition.model_width - static_cast<double>(grid.nx) * grid.dx);
    grid.origin[1] = 0.5 * (definition.model_height - static_cast<double>(grid.ny) * grid.dy);
  }
  require(hfrac_set_grid(sim, &grid), sim);
}

namespace {

std::vector<hfrac_cell> cells_of(hfrac_sim* sim, int32_t method) {
  const auto size = static_cast<int32_t>(sizeof(hfrac_cell));
  int64_t count = 0;
  require(hfrac_grid_cells(sim, method, size, nullptr, 0, &count), sim);
  std::vector<hfrac_cell> cells(static_cast<size_t>(count));
  require(hfrac_grid_cells(sim, method, size, cells.data(), count, &count), sim);
  return cells;
}

}  // namespace

bool grid_covers_model(hfrac_sim* sim) {
  const auto cells = cells_of(sim, HFRAC_UPSCALE_ODA);
  return std::any_of(cells.begin(), cells.end(), [](const hfrac_cell& cell) { return cell.coverage > 0.0; });
}

void write_cells(hfrac_sim* sim, int64_t nx, const std::filesystem::path& folder) {
  write_whole(folder / "cells.csv", cell_table(cells_of(sim, HFRAC_UPSCALE_FLOW), nx));
  for (const auto& [name, kind] : {std::pair{"permeability.grdecl", HFRAC_GRDECL_PERM},
                                   std::pair{"multipliers.grdecl", HFRAC_GRDECL_MULT}}) {
    const int32_t status =
        hfrac_write_grdecl(sim, (folder / name).c_str(), HFRAC_UPSCALE_FLOW, kind, 1, 0.0, 0.0);
    if (status < 0) fail_writing(error_text(status, sim));
  }
}

}  // namespace hfrac::output
