// SPDX-License-Identifier: BSD-3-Clause
// Traces of natural fractures as a file: what geologists digitise and DFN programs write.
#pragma once

#include <string>
#include <vector>

#include "options/options.hpp"

namespace hfrac::capi {

// `path` may be relative to the folder of the case file that names it.
std::string beside(const std::string& case_file, const std::string& path);

// A joint per trace of a file, all but its ends as in `like`. The ending of the name says how it is written:
//   .geojson, .json   a FeatureCollection of LineStrings and MultiLineStrings (RFC 7946; QGIS), each piece of a line a trace
//   any other         a table: comma-separated, the columns START_X, START_Y, END_X and END_Y in any order and among any others, of
//                     whatever case (fractopo, PorePy); empty lines and lines that begin with # are none
// in metres. Throws Error(case_file) with file, line and fault.
std::vector<JointOptions> read_traces(const std::string& path, const JointOptions& like);

}  // namespace hfrac::capi
