// SPDX-License-Identifier: BSD-3-Clause
// A network of traces as a file that a case reads, [[joint]] file = "...": a table, or GeoJSON by the ending of its name.
#pragma once

#include <string>
#include <vector>

#include "command/dfn_traces.hpp"

namespace hfrac::command {

/** Writes FID, START_X, START_Y, END_X, END_Y [m] and SET (from 1) to a tenth of a millimetre; `remark` stands at the top of a table. */
void write_traces(const std::string& path, const std::vector<Trace>& traces, const std::string& remark);

/** What hfrac_sim_def_add_traces reads of a file; its fault is BadInput. */
std::vector<Trace> read_traces(const std::string& path);

}  // namespace hfrac::command
