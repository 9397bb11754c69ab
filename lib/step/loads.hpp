// SPDX-License-Identifier: BSD-3-Clause
// All that a host or a case imposes on a model from outside, in one value.
//
// Options never change once a model is built; loads may change between any two steps. What acts on the model is always what its Loads
// say: impose() puts the difference on. A step that is tried again starts from the state before it and the loads as they are now.
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"
#include "step/engine.hpp"

namespace hfrac {

struct WellLoad {
  WellDrive drive;
  std::vector<ScheduleEntry> schedule;  // in order of time; turns the drive as time comes (step/stages.hpp)

  bool operator==(const WellLoad&) const = default;
};

struct Loads {
  double sigma_Hmax = 0.0, sigma_hmin = 0.0;  // Pa, far field along x and y, compression positive
  double formation_pressure = 0.0;            // Pa, absolute, in the pores outside
  bool boundary_pressure_set = false;         // by cell, in place of the formation pressure
  Array<double> boundary_excess;  // Pa over that of the outside, beyond each pipe of the outer boundary
  std::vector<Vec2> cell_load;    // N on each disc of the outer boundary, on top of the far field
  std::vector<WellLoad> wells;
  std::vector<double> well_temperature;  // K, of what is injected; empty without temperature
  Array<std::uint8_t> held_temperature;  // per disc: 1 keeps its temperature; likewise

  bool operator==(const Loads&) const = default;
};

// What acts on a model now: after it was built, or restored from an image.
Loads loads_of(const Model& model);

// Puts `wanted` on where it differs from `now`, which becomes the same.
void impose(Engine& engine, Loads& now, const Loads& wanted);

// The pressure in the pores outside if the formation's is `formation` [Pa]: both count from the datum of the convention of stress.
double outside_pressure(const Engine& engine, double formation);

}  // namespace hfrac
