// SPDX-License-Identifier: BSD-3-Clause
// Fields of the contacts of smooth joints (location 5), in the order of the bonds they stand for.
#pragma once

#include <cstdint>

#include "step/simulation.hpp"

namespace hfrac::capi {

// As those of field_values.hpp; false, and nothing written, if the field is of something else.
bool write_joint_values(const Simulation& simulation, std::int32_t field, double* to);
bool write_joint_indices(const Simulation& simulation, std::int32_t field, std::int32_t* to);

}  // namespace hfrac::capi
