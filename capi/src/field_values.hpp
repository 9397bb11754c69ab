// SPDX-License-Identifier: BSD-3-Clause
// Lays out the values of a field (hfrac/field.h) from the engine's arrays.
#pragma once

#include <cstdint>

#include "step/simulation.hpp"

namespace hfrac::capi {

// Fields of doubles and of int32; `to` has room for all values.
void write_values(const Simulation& simulation, std::int32_t field, double* to);
void write_indices(const Simulation& simulation, std::int32_t field, std::int32_t* to);

}  // namespace hfrac::capi
