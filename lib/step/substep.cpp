// SPDX-License-Identifier: BSD-3-Clause
// Steps that split: first the fluid, then the rock.
#include "options/choices.hpp"
#include "step/checks.hpp"
#include "step/ledger.hpp"
#include "step/rest.hpp"
#include "step/slips.hpp"
#include "step/stages.hpp"
#include "step/steppers.hpp"

namespace hfrac {

StepOutcome substep(Engine& e, double duration, const Interrupt& interrupt) {
  const std::size_t cracks_before = e.model.cracks.size();
  drive_wells(e);
  move_fluid(e, duration);
  e.mechanics->set_time(e.model.clock.time + duration);
  if (find_rest(e, interrupt).stopped) return {true, e.model.clock.at_rest};
  log_slips(e.model, e.model.clock.step + 1, e.model.clock.time + duration, duration);
  update_geometry(e);
  accumulate_flow(e, duration);
  close_step(e, duration, cracks_before);
  check_step(e);
  return {false, e.model.clock.at_rest};
}

StepOutcome dynamic_step(Engine& e, double duration, const Interrupt& interrupt) {
  const std::size_t cracks_before = e.model.cracks.size();
  drive_wells(e);
  move_fluid(e, duration);
  if (move_rock(e, duration, interrupt).stopped) return {true, e.model.clock.at_rest};
  log_slips(e.model, e.model.clock.step + 1, e.model.clock.time + duration, duration);
  update_geometry(e);
  accumulate_flow(e, duration);
  close_step(e, duration, cracks_before);
  check_step(e);
  return {false, e.model.clock.at_rest};
}

Stepper stepper_of(const Options& options) {
  switch (SteppingMode{options.stepping_mode}) {
    case SteppingMode::coupled:
      return coupled_step;
    case SteppingMode::dynamic:
      return dynamic_step;
    case SteppingMode::substep:
      break;
  }
  return substep;
}

}  // namespace hfrac
