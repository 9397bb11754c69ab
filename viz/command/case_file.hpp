// SPDX-License-Identifier: BSD-3-Clause
// From the name of a case file to a definition that can be built.
#pragma once

#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace hfrac::command {

/** Reads and checks a case file; BadInput with the engine's own sentence if it is wrong. `workers` > 0
 * replaces run.workers; with 0 a case that does not say gets the machine's cores, at most four. The definition borrows
 * `discs` (x, y, radius each), if there are any, in place of a packing, and `bonds` (two indices each) between them. */
Definition load_case(const std::string& file, int64_t workers, const std::vector<double>& discs = {},
                     const std::vector<int64_t>& bonds = {});

}  // namespace hfrac::command
