// SPDX-License-Identifier: BSD-3-Clause
// The pore pressure around a well that has seeped for a while: where a treatment of real rock begins.
//
// A plate with one round well is solved as a poroelastic continuum (biot_solver.hpp). All is counted from the state before
// the well stood at its pressure, so the far field does not enter.
#pragma once

#include <span>
#include <vector>

#include "core/array.hpp"
#include "rock/biot_material.hpp"

namespace hfrac {

struct SeepingWell {
  double width = 0.0, height = 0.0;  // of the plate, lower left corner at the origin [m]
  Vec2 centre;                       // [m]
  double radius = 0.0;               // [m]
  double excess = 0.0;               // pressure in the well and on its wall above the rock's [Pa]
  double duration = 0.0;             // since it stands there [s]; 0: until nothing changes any more
  bool outer_drained = true;         // the outer boundary at the rock's pressure; else no flow across it
  bool outer_held = false;  // the outer boundary cannot move along its normal; else under unchanged stress
};

// Pressure above the rock's at each place [Pa]; places in the well have the well's.
std::vector<double> seepage_pressure(const SeepingWell& well, const BiotMaterial& material,
                                     std::span<const Vec2> places);

}  // namespace hfrac
