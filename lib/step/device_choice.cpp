// SPDX-License-Identifier: BSD-3-Clause
#include "step/device_choice.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "options/choices.hpp"

namespace hfrac {
namespace {

// What stays on the processor; empty: nothing of this case.
std::string kept_by_the_processor(const CaseDefinition& definition, int ranks) {
  const Options& o = definition.options;
  if (SolverKind{o.solver_kind} == SolverKind::quasi_static) return "solver.kind = \"quasi-static\"";
  if (FractureLaw{o.fracture_law} == FractureLaw::facet) return "fracture.law = \"facet\"";
  if (BoundaryKind{o.boundary_kind} == BoundaryKind::infinite) return "boundary.kind = \"infinite\"";
  if (ranks > 1) return "one model over several ranks";
  return {};
}

}  // namespace

std::unique_ptr<Device> device_for(const CaseDefinition& definition, int ranks, std::string& why_none) {
  const RunDevice wanted{definition.options.run_device};
  if (wanted == RunDevice::cpu) return nullptr;
  if (const std::string what = kept_by_the_processor(definition, ranks); !what.empty()) {
    why_none = what + " runs on the processor alone";
    if (wanted == RunDevice::gpu)
      throw Error(ErrorKind::model, "run.device = \"gpu\", but " + why_none +
                                        "; set run.device to \"cpu\" or \"auto\", or change that.");
    return nullptr;
  }
  auto device = Device::open_first(why_none);
  if (device == nullptr && wanted == RunDevice::gpu)
    throw Error(ErrorKind::device, "run.device = \"gpu\", but no device can be used: " + why_none +
                                       "; set run.device to \"cpu\" or \"auto\".");
  return device;
}

}  // namespace hfrac
