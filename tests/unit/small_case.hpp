// SPDX-License-Identifier: BSD-3-Clause
// A small hydraulic-fracturing case that cracks within a few steps, for tests of whole simulations.
#pragma once

#include "model.hpp"
#include "step/host_state.hpp"
#include "step/impose.hpp"
#include "step/simulation.hpp"

namespace testing_unit {

// Effective stresses at 1 000 discs: rigid walls, no far field, hole of about 5 mean radii.
inline CaseDefinition cracking_case() {
  CaseDefinition definition;
  Options& o = definition.options;
  o.stress_convention = choice(StressConvention::effective);
  o.boundary_kind = choice(BoundaryKind::walls);
  o.packing_disc_count = 1000;
  o.stress_sigma_Hmax = o.stress_sigma_hmin = 0.0;
  WellOptions well;
  well.x = well.y = 50.0;
  well.radius = 8.5;
  well.pressure = 60e6;
  definition.wells.push_back(well);
  return definition;
}

// Rock whose stiffness is the same in tension and compression.
inline void make_linear(Options& o) {
  o.contact_mode = choice(ContactMode::after_break);
  o.contact_normal_stiffness = o.bond_normal_stiffness = 16e9;
  o.contact_shear_stiffness = o.bond_shear_stiffness = 5.6e9;
}

// Total stresses, stress boundary, nothing breaks.
inline CaseDefinition quiet_case() {
  CaseDefinition definition = cracking_case();
  Options& o = definition.options;
  o.stress_convention = choice(StressConvention::total);
  o.boundary_kind = choice(BoundaryKind::stress);
  o.packing_disc_count = 500;
  o.stress_sigma_Hmax = o.stress_sigma_hmin = 30e6;
  o.bond_tensile_strength = o.bond_shear_strength = 1e12;
  definition.wells[0].radius = 10.0;
  definition.wells[0].pressure = 30e6;
  return definition;
}

}  // namespace testing_unit
