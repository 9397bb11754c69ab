// SPDX-License-Identifier: BSD-3-Clause
// Ranks share one model, so each has to be given the same: a definition, then loads and lengths of steps. A host that read its input on one
// rank and told the others only half of it would have them wait for each other for ever, or agree on nonsense. What differs is
// looked for before it does harm, and refused on all ranks by its name.
#pragma once

#include <cstdint>
#include <span>

#include "core/ranks.hpp"
#include "model/model.hpp"
#include "options/options.hpp"
#include "step/loads.hpp"

namespace hfrac {

// But for run.workers, the title and where a packed model lies. Throws Error(argument).
void require_same_definition(const Ranks& ranks, const CaseDefinition& definition,
                             std::span<const double> discs, std::span<const std::int64_t> bonds);

// Before a step: what it is given, and by its clock and books the state that it begins from.
void require_same_step(const Ranks& ranks, const Model& model, const Loads& loads, double duration);

}  // namespace hfrac
