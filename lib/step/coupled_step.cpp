// SPDX-License-Identifier: BSD-3-Clause
// Steps in which flow, equilibrium and breakage are solved together (equilibrium/coupled_system.hpp), in increments as long as
// increment.hpp allows. Where the shortest finds no equilibrium, or one that may be led on, damped motion leads on (relax_dynamically).
//
// Heat moves with the flow of an increment once that is known; the rock feels it in the next.
#include <vector>

#include "core/error.hpp"
#include "options/number_text.hpp"
#include "step/checks.hpp"
#include "step/increment.hpp"
#include "step/ledger.hpp"
#include "step/rest.hpp"
#include "step/slips.hpp"
#include "step/snapshot.hpp"
#include "step/stages.hpp"
#include "step/steppers.hpp"

namespace hfrac {
namespace {

using End = EquilibriumSolver::End;
using Outcome = EquilibriumSolver::Outcome;

// The flow in every pipe is the increment's while a step goes on, for heat and ledger; what a host asks for afterwards (flow of pipes,
// outflow and leak-off of cells) is the mean over the step.
class MeanFlow {
 public:
  explicit MeanFlow(Network& network) : network_(network), passed_(network.flow.size(), 0.0) {}
  void add(double length) {
    for (std::size_t p = 0; p < passed_.size(); ++p) passed_[p] += length * network_.flow[p];
  }
  void put(double duration) {
    for (std::size_t p = 0; p < passed_.size(); ++p) network_.flow[p] = passed_[p] / duration;
  }

 private:
  Network& network_;
  std::vector<double> passed_;  // m2 per pipe
};

// The state before the increment again; what was counted since stays counted.
void put_back(Engine& e, const Outcome& outcome) {
  const SolverWork work = e.model.work;
  load_state(e, e.before_increment);
  e.model.work = work;
  count(e, outcome);
}

// An increment as short as that found no equilibrium: on by damped motion, or, unless it is the shortest, by a shorter one.
Outcome lead_on(Engine& e, const Outcome& stuck, IncrementControl& control, double length,
                const Interrupt& interrupt) {
  put_back(e, stuck);
  feel_heat(e);
  const Outcome settled = relax_dynamically(e, length, interrupt);
  if (settled.end == End::not_converged) {
    if (!control.shortest()) {
      control.was_not_led_on();
      return settled;
    }
    throw Error(ErrorKind::diverged,
                "no equilibrium was found at " + number_text(e.model.clock.time + control.done()) +
                    " s, not even for a part of " + number_text(length) +
                    " s: the unbalanced-force ratio stayed at " + rounded_text(stuck.force_ratio) +
                    ", farthest from rest near " + place_text(stuck.where) +
                    ", and damped motion left it at " + rounded_text(settled.force_ratio) +
                    " (eq. 8, 11, 12); the state before the step stands. Use a "
                    "lower pressure or rate, or change them in smaller steps");
  }
  return settled;
}

}  // namespace

StepOutcome coupled_step(Engine& e, double duration, const Interrupt& interrupt) {
  Model& m = e.model;
  const std::size_t cracks_before = m.cracks.size();
  drive_wells(e);
  IncrementControl control(e, duration);
  MeanFlow flow(m.network);
  while (!control.finished()) {
    const double length = control.begin();
    save_state(e, e.before_increment);
    feel_heat(e);
    e.equilibrium->set_time(m.clock.time + control.done() + length);
    Outcome outcome = solve_soundly(e, length, e.source, control.most_excess(), interrupt);
    if (outcome.end == End::not_converged && control.shortest() && e.facets.active())
      throw Error(ErrorKind::diverged,
                  "no equilibrium was found at " + number_text(m.clock.time + control.done()) + " s near " +
                      place_text(outcome.where) +
                      "; the state before the step stands. Use a lower pressure or rate, or a "
                      "shorter solver.smallest_step");
    const bool led = outcome.end == End::not_converged && control.leads_on() && !e.facets.active();
    if (led) outcome = lead_on(e, outcome, control, length, interrupt);
    if (outcome.end == End::stopped) return {true, m.clock.at_rest};
    if (!control.accepts(outcome)) {
      put_back(e, outcome);
      control.reject(outcome);
      continue;
    }
    count(e, outcome);
    ++m.work.increments;
    if (led) control.was_led_on();
    control.accept(outcome);
    m.clock.force_ratio = outcome.force_ratio;
    m.clock.at_rest = true;
    log_slips(m, m.clock.step + 1, m.clock.time + control.done(), length);
    accumulate_flow(e, length);
    flow.add(length);
    carry_second_fluid(e, length);
    move_heat(e, length);
    update_geometry(e);
  }
  flow.put(duration);
  close_step(e, duration, cracks_before);
  check_step(e);
  return {false, true};
}

}  // namespace hfrac
