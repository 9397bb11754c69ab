// SPDX-License-Identifier: BSD-3-Clause
// A user's own discs from a file: CSV, or VTU as the run folder holds it.
//
// CSV: a line of names, then a line per disc; comma, semicolon or blanks between. Columns x, y and radius (also x_m,
// y_m, radius_m) [m], in any order; others are skipped, as are empty lines and those that begin with #.
// VTU: points, and a point array radius or radius_m.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace hfrac::output {

/** The file is not what it should be; the text names file, line and fault. */
class DiscFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/** x, y, radius [m] of each disc, in the file's order. */
std::vector<double> read_discs(const std::filesystem::path& file);

/** The same as CSV text; reading it gives the same numbers. */
std::string discs_as_csv(const std::vector<double>& discs);

}  // namespace hfrac::output
