// SPDX-License-Identifier: BSD-3-Clause
// The state of a model that has come to rest under the far field, kept for others of the same making.
#pragma once

#include <vector>

#include "step/engine.hpp"
#include "step/packed_model.hpp"

namespace hfrac {

// The state that the initial equilibration left.
void keep_rest(const Engine& engine, PackedModel& kept);

// Takes it, in place of an initial equilibration; `pressure` [Pa]: what the pores hold then, by domain. How wells are driven, temperatures
// and r0 stay those of the case. Throws Error(argument) if the state is none of this model.
void load_rest(Engine& engine, const PackedModel& kept, const std::vector<double>& pressure);

}  // namespace hfrac
