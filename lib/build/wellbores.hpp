// SPDX-License-Identifier: BSD-3-Clause
// Which wells of a case need a wellbore with a pressure of its own (model/wellbore.hpp): those with friction, and clusters that share one.
#pragma once

#include "model/model.hpp"

namespace hfrac {

// After the wells are placed, before the network is built.
void begin_wellbores(Model& model, const CaseDefinition& definition);

// After the network is built: what holes store, well.fluid_area in place of the void between the discs, and a wellbore's storage.
void begin_holes(Model& model, const CaseDefinition& definition);

}  // namespace hfrac
