// SPDX-License-Identifier: BSD-3-Clause
// Numbers on the command line that CLI11 checks too little, or refuses with 309 digits.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <vector>

namespace hfrac::command {

/** A whole number of at least 0. */
CLI::Validator count_number();

/** A length above 0, in metres. */
CLI::Validator positive_length();

/** Refuses, in words, numbers of --grid that describe no grid: NX NY DX DY [X0 Y0 [DEGREES]]. */
void require_grid(const std::vector<double>& numbers);

}  // namespace hfrac::command
