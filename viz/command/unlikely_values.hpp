// SPDX-License-Identifier: BSD-3-Clause
// Values that are allowed but can only have been meant in MPa or GPa: all values are in SI units.
#pragma once

#include <hfrac/hfrac.h>

#include <string>
#include <vector>

namespace hfrac::command {

/** A sentence for each value of the definition that is plainly in another unit. */
std::vector<std::string> unlikely_values(const hfrac_sim_def& definition);

/** Refuses a target that is plainly in another unit, by the name of its option. */
void require_likely_targets(const hfrac_targets& targets);

}  // namespace hfrac::command
