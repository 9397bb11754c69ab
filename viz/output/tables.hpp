// SPDX-License-Identifier: BSD-3-Clause
// The CSV files of a run folder: SI units in the column names, numbers exact (they read back as the same
// doubles).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/engine_call.hpp"

namespace hfrac::output {
using namespace hfrac::run;

/** First line of history.csv. */
std::string history_header(hfrac_sim* sim);
/** One line of history.csv: how the simulation stands after a step. */
std::string history_row(hfrac_sim* sim);

/** cracks.csv: the whole crack log. */
std::string crack_table(const std::vector<hfrac_crack>& cracks);

/** The crack log of a run folder, read back. Throws ReadError. */
std::vector<hfrac_crack> read_crack_table(const std::filesystem::path& file);

/** The seismic catalogue of a crack log; `options` NULL: the defaults. */
std::vector<hfrac_event> events_of(const std::vector<hfrac_crack>& cracks,
                                   const hfrac_catalogue_options* options);
/** events.csv: that catalogue. */
std::string event_table(const std::vector<hfrac_event>& events);

/** fractures.csv: the fractures as they are now. */
std::string fracture_table(const std::vector<hfrac_fracture>& fractures);

/** cells.csv: the cells of a reservoir simulator's grid, `nx` to a row, i fastest. */
std::string cell_table(const std::vector<hfrac_cell>& cells, int64_t nx);

/** What of all fractures goes into one line: the longest one, and the volume of all. */
struct FractureMeasure {
  double length = 0.0;  ///< [m] of the longest fracture
  double width = 0.0;   ///< [m] largest aperture of the longest fracture
  double volume = 0.0;  ///< [m2] of all fractures
};
FractureMeasure measure(const std::vector<hfrac_fracture>& fractures);

}  // namespace hfrac::output
