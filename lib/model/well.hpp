// SPDX-License-Identifier: BSD-3-Clause
// A well: where it lies, how it is driven at present, what it took.
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"
#include "options/options.hpp"

namespace hfrac {

struct WellPlace {
  Vec2 centre;               // m
  double equivalent_radius;  // m
  std::int32_t domain;
};

// How a well is driven: the value that `control` names counts, the others wait.
struct WellDrive {
  WellControl control = WellControl::pressure;
  double target_pressure = 0.0;  // Pa
  double ramp_per_step = 0.0;    // Pa
  double set_rate = 0.0;         // m2/s
  WellFluid fluid = WellFluid::first;

  bool operator==(const WellDrive&) const = default;
};

struct Well {
  WellPlace place;
  WellDrive drive;                      // now: as imposed, or as the schedule has turned it since
  double rate = 0.0;                    // m2/s into the well in the last step
  double injected = 0.0;                // m2 since the model came to rest
  double content = 0.0;                 // m2 at the end of the last step
  double taken = 0.0;                   // m2 in the increments of the step so far
  std::vector<ScheduleEntry> schedule;  // in order of time; `well` is not looked at
  std::int32_t wellbore = -1;  // of Model::wellbores that it is a cluster of; -1: the hole is all there is
  double storage = 0.0;        // m2/Pa, of a well without such a wellbore: part of what its hole stores
  double head = 0.0,
         second_head =
             0.0;         // Pa, rho g depth of both fluids: by how much the pressure at the wellhead is lower
  std::int64_t next = 0;  // of the schedule: entries before it hold or are past
};

}  // namespace hfrac
