// SPDX-License-Identifier: BSD-3-Clause
// Traces of natural fractures as a table: what geologists digitise and DFN programs write.
#pragma once

#include <string>
#include <vector>

#include "options/options.hpp"

namespace hfrac::capi {

// `path` may be relative to the folder of the case file that names it.
std::string beside(const std::string& case_file, const std::string& path);

// A joint per line of a CSV file with columns START_X, START_Y, END_X and END_Y [m], in any order and among any others, of whatever
// case (fractopo, PorePy); all else as in `like`. Empty lines and lines that begin with # are none. Throws Error(case_file) with file,
// line and fault.
std::vector<JointOptions> read_traces(const std::string& path, const JointOptions& like);

}  // namespace hfrac::capi
