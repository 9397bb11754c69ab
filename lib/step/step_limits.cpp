// SPDX-License-Identifier: BSD-3-Clause
#include "step/step_limits.hpp"

#include <algorithm>

#include "options/choices.hpp"

namespace hfrac {

StepLimits step_limits(const Simulation& s) {
  constexpr double unlimited = 1e300;
  const Options& o = s.options();
  StepLimits limits;
  limits.flow_step = s.next_step();
  limits.mechanical_step = s.engine_as_is().mechanics->real_step();
  limits.explicit_step = std::min(unlimited, FlowSolver::explicit_limit(s.network()));
  const double mechanics =
      SteppingMode{o.stepping_mode} == SteppingMode::dynamic ? limits.mechanical_step : unlimited;
  const double flow =
      FlowScheme{o.flow_scheme} == FlowScheme::explicit_scheme ? 0.5 * limits.explicit_step : unlimited;
  if (std::min(mechanics, flow) < limits.flow_step)
    limits.binding = mechanics <= flow ? StepLimit::mechanics : StepLimit::flow;
  return limits;
}

}  // namespace hfrac
