// SPDX-License-Identifier: BSD-3-Clause
// A step-rate test: the rate is raised in steps, and the pressure at the end of each rises with it along a straight line through the
// rock, then, once a fracture is open, along a flatter one. The two lines cross at the pressure of extension (Earlougher 1977).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/injection_record.hpp"

namespace hfrac::command {

struct RateStep {
  double begin = 0.0, end = 0.0;  ///< [s]
  double rate = 0.0;              ///< [m2/s] mean
  double pressure = 0.0;          ///< [Pa] mean over the last tenth of it
};

struct StepRateReading {
  std::vector<RateStep> steps;  ///< rising, from the beginning of the injection on; empty: no such test
  std::optional<double> rate, pressure;          ///< [m2/s], [Pa] where the two lines cross
  double slope_before = 0.0, slope_after = 0.0;  ///< [Pa s/m2]
  std::string note;                              ///< why there is no pressure
};

/** Of the injection before a shut-in. Fewer than four rising steps are no step-rate test: no steps, no note. */
StepRateReading read_step_rate(const InjectionRecord& record, const ShutIn& shut_in);

}  // namespace hfrac::command
