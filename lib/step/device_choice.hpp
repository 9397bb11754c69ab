// SPDX-License-Identifier: BSD-3-Clause
// On what the cycles of a simulation run (run.device): the processor, or a card.
#pragma once

#include <memory>
#include <string>

#include "core/device.hpp"
#include "options/options.hpp"

namespace hfrac {

// The device that a case asks for; null: the processor, and with run.device = "auto" why. Throws Error(device) where "gpu" is asked for
// and there is none, Error(model) where the case cannot run on one. Options are resolved (fracture.law); `ranks`: how many hold the model.
std::unique_ptr<Device> device_for(const CaseDefinition& definition, int ranks, std::string& why_none);

}  // namespace hfrac
