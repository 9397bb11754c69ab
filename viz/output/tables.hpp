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

/** slips.csv: what smooth joints slipped, and read back. Throws ReadError. */
std::string slip_table(const std::vector<hfrac_slip>& slips);
std::vector<hfrac_slip> read_slip_table(const std::filesystem::path& file);

/** The seismic catalogue of both logs, in order of time; `options` NULL: the defaults. */
std::vector<hfrac_event> events_of(const std::vector<hfrac_crack>& cracks,
                                   const std::vector<hfrac_slip>& slips,
                                   const hfrac_catalogue_options* options);
/** events.csv: that catalogue. */
std::string event_table(const std::vector<hfrac_event>& events);

/** fractures.csv: the fractures as they are now. */
std::string fracture_table(const std::vector<hfrac_fracture>& fractures);
/** fracture_lines.csv: of each fracture its line from tip to tip. */
std::string line_table(const std::vector<std::vector<hfrac_fracture_point>>& lines);

/** cells.csv: the cells of a reservoir simulator's grid, `nx` to a row, i fastest. */
std::string cell_table(const std::vector<hfrac_cell>& cells, int64_t nx);

/** What of all fractures goes into one line: the longest one, and the volume of all. */
struct FractureMeasure {
  double length = 0.0;  ///< [m] of the longest fracture
  double width = 0.0;   ///< [m] largest aperture of the longest fracture
  double volume = 0.0;  ///< [m2] of all fractures
};
FractureMeasure measure(const std::vector<hfrac_fracture>& fractures);

// The arrays of a simulation as CSV: a line per disc, per bond (with its pipe), per domain and per
// contact of a smooth joint.
//
// Columns come from the interface's own list of fields (hfrac/field.h), so a field that is added there is in the table too.
// A name is that of the field without its location, the component (x, y; xx, yy, xy; 0, 1) and the unit:
// displacement_x_m, stress_xy_Pa; of several indices the singular: disc_0, disc_1. Positions are plain x_m and y_m. So
// `hfrac run --discs discs.csv --bonds bonds.csv` reads the tables.

/** Every field of the discs. */
std::string disc_table(hfrac_sim* sim);
/** Every field of the bonds and of the pipes that cross them. */
std::string bond_table(hfrac_sim* sim);
/** Every field of the domains, but for their corners. */
std::string domain_table(hfrac_sim* sim);
/** Every field of the contacts of smooth joints. */
std::string joint_table(hfrac_sim* sim);

}  // namespace hfrac::output
