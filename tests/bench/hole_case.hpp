// SPDX-License-Identifier: BSD-3-Clause
// The paper's rock around a well in tiled bricks, in real time, a millisecond a step.
#pragma once

#include <cstdint>

#include "options/choices.hpp"
#include "options/options.hpp"

namespace hfrac::bench {

inline CaseDefinition hole_case(std::int64_t discs, int workers) {
  CaseDefinition definition;
  Options& o = definition.options;
  o.stress_convention = static_cast<std::int64_t>(StressConvention::effective);
  o.boundary_kind = static_cast<std::int64_t>(BoundaryKind::walls);
  o.stepping_mode = static_cast<std::int64_t>(SteppingMode::dynamic);
  o.stepping_flow_step = 1e-3;
  o.packing_disc_count = discs;
  o.packing_method = static_cast<std::int64_t>(PackingMethod::tiled);
  o.stress_sigma_Hmax = o.stress_sigma_hmin = 0.0;
  o.run_workers = workers;
  definition.wells.push_back({50.0, 50.0, 8.5, 45e6, 0.0, 0.0, WellControl::pressure});
  return definition;
}

}  // namespace hfrac::bench
