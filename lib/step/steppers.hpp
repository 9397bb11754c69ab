// SPDX-License-Identifier: BSD-3-Clause
// The three ways to take a step, one per value of stepping.mode. All go through the same stages (stages.hpp), in this order:
//
//   1  drive_wells      wells take their pressures or rates, of their schedule if they have one
//   2  move_fluid       fluid moves along the pipes while the rock stands still (eq. 6, 8); heat moves with it, and discs grow by it
//   3  the rock         find_rest, move_rock or solve_together: forces (eq. 15-20), breakage (eq. 21-23), undrained pores (eq. 8),
//                       pressures on discs (eq. 9-14), boundary, motion (eq. 11, 12)
//   4  update_geometry  apertures and conductances where the rock is now (eq. 6, 7); new contacts around cracks
//   5  accumulate_flow        what the time that passed injected and leaked
//   6  close_step       clock, rates of the step, farthest crack tip
//   7  check_step       numbers that are no numbers, and what else no step may leave behind
//
// Between 2 and 3 no fluid is lost or made: pores keep their content while the rock moves. Freezing the pressure instead (the drained
// split) is unstable. Simulation::step puts the loads on before and, if a step fails or is interrupted, the state back.
#pragma once

#include "step/engine.hpp"

namespace hfrac {

struct StepOutcome {
  bool stopped = false;  // by the interrupt; the step was undone
  bool at_rest = true;
};

using Stepper = StepOutcome (*)(Engine& engine, double duration, const Interrupt& interrupt);

// One flow step, then the rock moves to rest (mode substep).
StepOutcome substep(Engine& engine, double duration, const Interrupt& interrupt);
// One flow step, then the rock moves for as long, by Newton's law in real time (mode dynamic).
StepOutcome dynamic_step(Engine& engine, double duration, const Interrupt& interrupt);
// Flow, equilibrium and breakage together, in increments of the step (mode coupled).
StepOutcome coupled_step(Engine& engine, double duration, const Interrupt& interrupt);

Stepper stepper_of(const Options& options);

}  // namespace hfrac
