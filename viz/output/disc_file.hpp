// SPDX-License-Identifier: BSD-3-Clause
// A user's own discs, and which of them are bonded, from files: CSV, or for discs VTU as the run folder holds it.
//
// CSV: a line of names, then a line per disc; comma, semicolon or blanks between. Columns x, y and radius (also x_m,
// y_m, radius_m) [m], in any order; others are skipped, as are empty lines and those that begin with #.
// Bonds: columns disc_0 and disc_1, indices from 0 in the order of the discs; lines whose column state, if there is one, is
// not 0 (broken) are left out.
// VTU: points, and a point array radius or radius_m; one piece, its numbers ascii, binary or appended raw.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "run/files.hpp"

namespace hfrac::output {

/** The file is not what it should be; the text names file, line and fault. */
using DiscFileError = run::ReadError;

/** x, y, radius [m] of each disc, in the file's order. */
std::vector<double> read_discs(const std::filesystem::path& file);

/** The two discs of each bond, in the file's order. */
std::vector<int64_t> read_bonds(const std::filesystem::path& file);

/** The same as CSV text; reading it gives the same numbers. */
std::string discs_as_csv(const std::vector<double>& discs);
std::string bonds_as_csv(const std::vector<int64_t>& bonds);

}  // namespace hfrac::output
