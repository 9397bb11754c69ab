// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a simulation as CSV: a line per disc, per bond (with its pipe) and per domain.
//
// Columns come from the interface's own list of fields (hfrac/field.h), so a field that is added there is in the table too.
// A name is that of the field without its location, the component (x, y; xx, yy, xy; 0, 1) and the unit:
// displacement_x_m, stress_xy_Pa; of several indices the singular: disc_0, disc_1. Positions are plain x_m and y_m. So
// `hfrac run --discs discs.csv --bonds bonds.csv` reads the tables.
#pragma once

#include <string>

#include "run/engine_call.hpp"

namespace hfrac::output {
using namespace hfrac::run;

/** Every field of the discs. */
std::string disc_table(hfrac_sim* sim);
/** Every field of the bonds and of the pipes that cross them. */
std::string bond_table(hfrac_sim* sim);
/** Every field of the domains, but for their corners. */
std::string domain_table(hfrac_sim* sim);

}  // namespace hfrac::output
