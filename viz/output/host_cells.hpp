// SPDX-License-Identifier: BSD-3-Clause
// What a reservoir simulator's grid reads of a run: cells.csv and include files for Eclipse decks.
#pragma once

#include <hfrac/hfrac.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hfrac::output {

/** Lays a regular grid over the model: `numbers` are nx, ny, dx, dy [m], and, if given, x and y of its first corner [m] and
 * its angle [degrees]; without a corner it is put in the middle of the model. Throws EngineError if there is no such grid. */
void lay_grid(hfrac_sim* sim, const std::vector<double>& numbers);

/** Whether any of the model lies in the grid that was laid. */
bool grid_covers_model(hfrac_sim* sim);

/** Writes every cell of the grid as it is now, by flow through its pipes: cells.csv, permeability.grdecl and
 * multipliers.grdecl into a run folder. */
void write_cells(hfrac_sim* sim, int64_t nx, const std::filesystem::path& folder);

}  // namespace hfrac::output
