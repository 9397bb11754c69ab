// SPDX-License-Identifier: BSD-3-Clause
// How long a step may be, by each of the things that limit it.
#pragma once

#include "step/simulation.hpp"

namespace hfrac {

enum class StepLimit : std::int32_t { none = 0, mechanics = 1, flow = 2 };

struct StepLimits {
  double flow_step = 0.0;               // s, the next step
  double mechanical_step = 0.0;         // s, stable cycle of real motion
  double explicit_step = 0.0;           // s, stable sub-cycle of explicit flow
  StepLimit binding = StepLimit::none;  // what takes the step in shorter pieces
};
StepLimits step_limits(const Simulation& simulation);

}  // namespace hfrac
