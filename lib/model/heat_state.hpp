// SPDX-License-Identifier: BSD-3-Clause
// Temperatures of a model and its heat balance.
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

struct HeatState {
  Array<double> disc;   // K
  Array<double> felt;   // K per disc: what growth and micro-parameters follow, that of the last equilibrium
  Array<double> fluid;  // K per domain
  Array<std::uint8_t> held;  // per disc: 1 keeps its temperature
  std::vector<double> well;  // K per well: of what is injected
  // J/m since the initial equilibration, counted from the temperature at set-up: into rock and pores
  double from_wells = 0.0, from_outside = 0.0, from_held = 0.0, from_host = 0.0;
  double thermal_work = 0.0;  // J/m of elastic energy that changes of temperature put in or took out

  template <class Archive, class Self>
  static void visit(Archive& archive, Self& s) {
    for (auto* values : {&s.disc, &s.felt, &s.fluid}) archive.array(*values);
    archive.array(s.held);
    archive.array(s.well);
    for (auto* value : {&s.from_wells, &s.from_outside, &s.from_held, &s.from_host, &s.thermal_work})
      archive.value(*value);
  }
};

}  // namespace hfrac
