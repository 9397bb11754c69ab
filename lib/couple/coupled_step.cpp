// SPDX-License-Identifier: BSD-3-Clause
// Steps of the quasi-static solver.
//
// substep  the order of step.cpp, with equilibrium solved for instead of waited for
// coupled  flow, equilibrium and breakage solved together (equilibrium/coupled_system.hpp) in increments of a step. An increment is as
//          long as three things allow: the error of backward Euler, estimated against a straight line through the increment before;
//          no bond farther beyond its strength than solver.strength_overshoot before it breaks; convergence. An increment that
//          fails one of them is rejected and tried again shorter, down to solver.smallest_step. Where that fails, damped
//          motion leads on (relax_dynamically).
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "couple/simulation.hpp"
#include "flow/aperture.hpp"
#include "options/number_text.hpp"

namespace hfrac {
namespace {

constexpr double longest_growth = 4.0, shortest_cut = 0.1;
// A length at which no rest was found is kept away from in the rest of the step, less and less so with every increment that went well.
constexpr double below_failed = 0.7, forgetting = 1.2;

std::string place_text(Vec2 at) {
  std::string text = "(";  // in two steps: GCC 12 takes a literal plus a temporary for an overlap
  text += rounded_text(at.x) + ", " + rounded_text(at.y) + ") m";
  return text;
}

}  // namespace

Simulation::StepOutcome Simulation::quasi_static_substep(double duration,
                                                         const std::function<bool()>& interrupt) {
  using End = EquilibriumSolver::End;
  flow_step(duration);
  const std::size_t cracks_before = cracks_.size();
  save_state(before_increment_);
  auto rest = equilibrium_->solve(0.0, {}, std::numeric_limits<double>::infinity(), cracks_, interrupt);
  if (rest.end == End::not_converged) {
    load_state(before_increment_);
    count(rest);
    const auto relaxed = relax_dynamically(0.0, interrupt);
    if (relaxed.end == End::not_converged) {
      throw Error(ErrorKind::diverged, "no equilibrium was found after " + number_text(time_) +
                                           " s: the unbalanced-force ratio stayed at " +
                                           rounded_text(rest.force_ratio) + ", farthest from rest near " +
                                           place_text(rest.where) + ", and damped motion left it at " +
                                           rounded_text(relaxed.force_ratio) +
                                           " (eq. 11, 12); the state before the step stands. Use a shorter "
                                           "stepping.flow_step, or a lower pressure or rate");
    }
    rest = relaxed;
  }
  if (rest.end == End::stopped) return {true, at_rest_};
  count(rest);
  force_ratio_ = rest.force_ratio;
  at_rest_ = true;
  if (flow_) update_apertures(network_, assembly_, options());
  solver_->search_contacts(cracks_);
  finish_step(duration, cracks_before);
  return {false, true};
}

// Where Newton's method finds no equilibrium there may be none near: a bond that breaks can make the rock jump. Damped motion from
// the last state leads where the jump ends (dynamic relaxation, Otter, Cassell and Hobbs 1966; damping of Cundall 1987), as the explicit
// solver would; from there equilibrium is solved for to the same tolerance. Fluid flows first, for `increment` seconds, while the rock
// stands still: as long as the shortest increment, so it hardly does.
EquilibriumSolver::Outcome Simulation::relax_dynamically(double increment,
                                                         const std::function<bool()>& interrupt) {
  using End = EquilibriumSolver::End;
  const Options& o = options();
  if (flow_ && increment > 0.0) flow_rounds_ = flow_->advance(network_, increment, source_);
  EquilibriumSolver::Outcome outcome;
  auto motion = solver_->relax(o.stepping_force_ratio, o.stepping_max_cycles, cracks_, interrupt);
  if (motion.at_rest) {
    solver_->evaluate();
    std::vector<std::byte> relaxed;
    save_state(relaxed);
    outcome = equilibrium_->solve(0.0, {}, std::numeric_limits<double>::infinity(), cracks_, interrupt);
    if (outcome.end != End::not_converged) return outcome;
    load_state(relaxed);
    motion = solver_->relax(o.solver_tolerance, o.stepping_max_cycles, cracks_, interrupt);
    solver_->stop_motion();
    solver_->evaluate();
    boundary_->remove_rigid_motion(assembly_);
    outcome.last_excess = equilibrium_->find_exceeding();
  }
  outcome.end = motion.stopped ? End::stopped : (motion.at_rest ? End::rest : End::not_converged);
  outcome.force_ratio = motion.force_ratio;
  return outcome;
}

void Simulation::count(const EquilibriumSolver::Outcome& outcome) {
  work_.newton += outcome.newton;
  work_.krylov += outcome.krylov;
  work_.factors += outcome.factors;
  work_.rounds += outcome.rounds;
}

// Backward Euler's error of an increment: how far the pressures lie from where the increment before was heading, half of it, over
// how far they lie from the formation's; both summed over the pores.
double Simulation::increment_error(double increment) const {
  double off = 0.0, all = 0.0;
  for (std::size_t d = 1; d < network_.kind.size(); ++d) {
    if (network_.stiffness[d] <= 0.0) continue;
    const double heading = increment_pressure_[d] + increment * pressure_rate_[d];
    off += 0.5 * std::abs(network_.pressure[d] - heading);
    all += std::max(std::abs(network_.pressure[d] - network_.reference_pressure),
                    std::abs(increment_pressure_[d] - network_.reference_pressure));
  }
  return all > 0.0 ? off / all : 0.0;
}

Simulation::StepOutcome Simulation::coupled_step(double duration, const std::function<bool()>& interrupt) {
  using End = EquilibriumSolver::End;
  const Options& o = options();
  const std::size_t cracks_before = cracks_.size();
  double done = 0.0, tried_increment = 0.0, tried_rise = 0.0;
  double failed_increment = std::numeric_limits<double>::infinity();
  bool sudden = false;
  if (!(increment_ > 0.0)) increment_ = duration;
  while (done < duration) {
    double increment = std::min(increment_, duration - done);
    if (increment < duration - done && 2.0 * increment > duration - done) increment = 0.5 * (duration - done);
    save_state(before_increment_);
    feel_heat();
    increment_pressure_.assign(network_.pressure.begin(), network_.pressure.end());
    const std::size_t cracks_at = cracks_.size();
    const bool shortest = increment <= o.solver_smallest_step;
    const bool any_excess = shortest || sudden;
    auto outcome = equilibrium_->solve(
        increment, source_,
        any_excess ? std::numeric_limits<double>::infinity() : 1.0 + o.solver_strength_overshoot, cracks_,
        interrupt);
    if (outcome.end == End::not_converged && shortest) {
      SolverWork tried = work_;
      ++tried.rejected_divergence;
      load_state(before_increment_);
      work_ = tried;
      count(outcome);
      feel_heat();
      const auto relaxed = relax_dynamically(increment, interrupt);
      if (relaxed.end == End::not_converged) {
        throw Error(ErrorKind::diverged,
                    "no equilibrium was found at " + number_text(time_ + done) +
                        " s, not even for an increment of " + number_text(increment) +
                        " s: the unbalanced-force ratio stayed at " + rounded_text(outcome.force_ratio) +
                        ", farthest from rest near " + place_text(outcome.where) +
                        ", and damped motion left it at " + rounded_text(relaxed.force_ratio) +
                        " (eq. 8, 11, 12); the state before the step stands. Use a "
                        "lower pressure or rate, or change them in smaller steps");
      }
      outcome = relaxed;
      sudden = true;
    }
    if (outcome.end == End::stopped) return {true, at_rest_};
    const double error = outcome.end == End::rest ? increment_error(increment) : 0.0;
    const bool broke = cracks_.size() > cracks_at;
    if (outcome.end != End::rest || (error > 3.0 * o.solver_pressure_change && !shortest)) {
      // If a well's pressure jumped, no length of an increment makes what it does small: first the jump, in no time, then the rest.
      bool jump = done == 0.0 && jumped_ && !sudden;
      double cut = 0.25;
      SolverWork rejected = work_;
      if (outcome.end == End::overshoot) {
        // Where between the last increment's stress and this one's the first bond reaches its strength, if stress rises with a power
        // of the increment: 1, or what two tries say. If it hardly rises, the load is sudden and no length of an increment will do.
        const double rise = outcome.excess - excess_;
        double power = 1.0;
        if (tried_increment > 0.0)
          power = std::log(tried_rise / rise) / std::log(tried_increment / increment);
        jump = jump || power < 0.15;
        tried_increment = increment;
        tried_rise = rise;
        cut = std::pow((1.0 + 0.5 * o.solver_strength_overshoot - excess_) / rise,
                       1.0 / std::clamp(power, 0.4, 2.0));
        ++rejected.rejected_strength;
      } else if (outcome.end == End::rest) {
        cut = 0.9 * std::sqrt(o.solver_pressure_change / error);
        ++rejected.rejected_error;
      } else {
        ++rejected.rejected_divergence;
        failed_increment = std::min(failed_increment, increment);
      }
      load_state(before_increment_);
      work_ = rejected;
      count(outcome);
      sudden = sudden || jump;
      increment_ = jump ? o.solver_smallest_step
                        : std::max(o.solver_smallest_step, increment * std::clamp(cut, shortest_cut, 0.9));
      continue;
    }
    count(outcome);
    ++work_.increments;
    const double rise = outcome.last_excess - excess_,
                 room = 1.0 + 0.5 * o.solver_strength_overshoot - outcome.last_excess;
    excess_ = std::min(outcome.last_excess, 1.0);
    for (std::size_t d = 0; d < pressure_rate_.size(); ++d)
      pressure_rate_[d] = broke || sudden ? 0.0 : (network_.pressure[d] - increment_pressure_[d]) / increment;
    force_ratio_ = outcome.force_ratio;
    at_rest_ = true;
    accumulate_flow(increment);
    move_heat(increment);
    done += increment;
    update_apertures(network_, assembly_, o);
    solver_->search_contacts(cracks_);
    double growth =
        error > 0.0 && !sudden ? 0.9 * std::sqrt(o.solver_pressure_change / error) : longest_growth;
    // What rose like this will be at its strength then.
    if (!broke && !sudden && rise > 0.0) growth = std::min(growth, std::max(room / rise, shortest_cut));
    sudden = false;
    tried_increment = 0.0;
    if (increment == increment_ || growth < 1.0)
      increment_ = std::min(increment * std::clamp(growth, shortest_cut, longest_growth),
                            below_failed * failed_increment);
    failed_increment *= forgetting;
  }
  close_step(duration, cracks_before);
  return {false, true};
}

}  // namespace hfrac
