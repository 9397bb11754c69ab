// SPDX-License-Identifier: BSD-3-Clause
// Where a simulation stands in time, what its solvers did, and what passed in and out so far.
#pragma once

#include <cstdint>

#include "core/array.hpp"

namespace hfrac {

struct Clock {
  double time = 0.0;          // s
  std::int64_t step = 0;      // steps taken
  std::int64_t cycles = 0;    // of the explicit solver, and iterations of the quasi-static one
  double force_ratio = 0.0;   // mean unbalanced over mean contact force at the last look
  bool at_rest = true;        // whether that was low enough
  int flow_rounds = 0;        // sub-cycles or rounds of the last flow solve
  double tip_distance = 0.0;  // m, farthest crack tip from the nearest well
};

// What the quasi-static solver did since the model came to rest.
struct SolverWork {
  std::int64_t increments = 0, rounds = 0, newton = 0, krylov = 0, factors = 0;
  std::int64_t rejected_error = 0, rejected_strength = 0, rejected_divergence = 0;
};

// Mode coupled: what the length of the next increment follows from (step/increment.hpp).
struct IncrementState {
  double length = 0.0;          // s
  double excess = 0.0;          // largest stress over strength so far
  Array<double> pressure_rate;  // Pa/s per domain in the last increment
};

// Work of friction, damping and fluid, and what breakage released: J/m since the model came to rest.
struct Energies {
  double friction = 0.0, damping = 0.0, fluid = 0.0, fracture = 0.0;
  double held = 0.0;  // work of the couple against what facets turn the whole by (solid/facet_motion.hpp)
};

// Second fluid (flow/second_fluid.hpp) that came in from wells, from a host (negative: it took some), and left through the outer boundary [m2].
struct SecondFluidBooks {
  double from_wells = 0.0, from_host = 0.0, leaked = 0.0;
};

// What the ledger (step/ledger.hpp) adds up besides.
struct Accounts {
  Energies energies;
  double leaked = 0.0;          // m2 out through the outer boundary
  double host_added = 0.0;      // m2 put into pores by a host
  double outside_work = 0.0;    // J/m, by earlier pressures outside, up to outside_change
  double outside_change = 0.0;  // m2, volume change of the outside when its pressure last changed
  SecondFluidBooks second;
};

// What displacements, contents and energies are measured from: the model at rest, before the first step.
struct StartState {
  Array<double> x, y, rotation;  // m, m, rad: displacement since bonding
  Array<double> content;         // m2 per domain; in a dry model per well, since nothing else changes
  double bond_energy = 0.0, contact_energy = 0.0, boundary_work = 0.0;  // J/m
};

}  // namespace hfrac
