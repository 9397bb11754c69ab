// SPDX-License-Identifier: BSD-3-Clause
#include "step/increment.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

using End = EquilibriumSolver::End;

constexpr double longest_growth = 4.0, shortest_cut = 0.1;
// A length at which no rest was found is kept away from in the rest of the step, less and less so with every increment that went well.
constexpr double below_failed = 0.7, forgetting = 1.2;
// Without rest so many times while nothing broke; each time more lengthens what is led on, and what breaks shortens it.
constexpr int patience = 16;
constexpr double led_longer = 2.0, led_shorter = 0.25;

}  // namespace

IncrementControl::IncrementControl(Engine& engine, double duration)
    : engine_(engine),
      state_(engine.model.increment),
      duration_(duration),
      longest_led_(engine.options.solver_smallest_step) {
  if (!(state_.length > 0.0)) state_.length = duration;
}

double IncrementControl::begin() {
  const double left = duration_ - done_;
  length_ = std::min(state_.length, left);
  if (length_ < left && 2.0 * length_ > left) length_ = 0.5 * left;
  const auto& pressure = engine_.model.network.pressure;
  pressure_before_.assign(pressure.begin(), pressure.end());
  cracks_before_ = engine_.model.cracks.size();
  return length_;
}

double IncrementControl::most_excess() const {
  return shortest() || sudden_ ? std::numeric_limits<double>::infinity()
                               : 1.0 + engine_.options.solver_strength_overshoot;
}

void IncrementControl::found_no_rest() {
  if (++without_rest_ > patience) longest_led_ *= led_longer;
}

void IncrementControl::was_led_on() {
  sudden_ = true;
  ++engine_.model.work.rejected_divergence;
  found_no_rest();
}

void IncrementControl::was_not_led_on() {
  without_rest_ = 0;
  longest_led_ = engine_.options.solver_smallest_step;
}

// Backward Euler's error: how far the pressures lie from where the increment before was heading, half of it, over
// how far they lie from the formation's; both summed over the pores.
double IncrementControl::error() const {
  const Network& n = engine_.model.network;
  double off = 0.0, all = 0.0;
  for (std::size_t d = 1; d < n.kind.size(); ++d) {
    if (n.stiffness[d] <= 0.0) continue;
    const double heading = pressure_before_[d] + length_ * state_.pressure_rate[d];
    off += 0.5 * std::abs(n.pressure[d] - heading);
    all += std::max(std::abs(n.pressure[d] - n.reference_pressure),
                    std::abs(pressure_before_[d] - n.reference_pressure));
  }
  return all > 0.0 ? off / all : 0.0;
}

bool IncrementControl::accepts(const EquilibriumSolver::Outcome& outcome) {
  error_ = outcome.end == End::rest ? error() : 0.0;
  return outcome.end == End::rest && !(error_ > 3.0 * engine_.options.solver_pressure_change && !shortest());
}

void IncrementControl::reject(const EquilibriumSolver::Outcome& outcome) {
  const Options& o = engine_.options;
  SolverWork& work = engine_.model.work;
  // If a well's pressure jumped, no length of an increment makes what it does small: first the jump, in no time, then the rest.
  bool jump = done_ == 0.0 && engine_.well_jumped && !sudden_;
  double cut = 0.25;
  if (outcome.end == End::overshoot) {
    // Where between the last increment's stress and this one's the first bond reaches its strength, if stress rises with a power
    // of the length: 1, or what two tries say. If it hardly rises, the load is sudden and no length will do.
    const double rise = outcome.excess - state_.excess;
    double power = 1.0;
    if (tried_length_ > 0.0) power = std::log(tried_rise_ / rise) / std::log(tried_length_ / length_);
    jump = jump || power < 0.15;
    tried_length_ = length_;
    tried_rise_ = rise;
    cut = std::pow((1.0 + 0.5 * o.solver_strength_overshoot - state_.excess) / rise,
                   1.0 / std::clamp(power, 0.4, 2.0));
    ++work.rejected_strength;
  } else if (outcome.end == End::rest) {
    cut = 0.9 * std::sqrt(o.solver_pressure_change / error_);
    ++work.rejected_error;
  } else {
    ++work.rejected_divergence;
    stuck_length_ = std::min(stuck_length_, length_);
    found_no_rest();
  }
  sudden_ = sudden_ || jump;
  state_.length = jump ? o.solver_smallest_step
                       : std::max(o.solver_smallest_step, length_ * std::clamp(cut, shortest_cut, 0.9));
}

void IncrementControl::accept(const EquilibriumSolver::Outcome& outcome) {
  const Options& o = engine_.options;
  const bool broke = engine_.model.cracks.size() > cracks_before_;
  const auto& pressure = engine_.model.network.pressure;
  const double rise = outcome.last_excess - state_.excess,
               room = 1.0 + 0.5 * o.solver_strength_overshoot - outcome.last_excess;
  if (broke) {
    without_rest_ = 0;
    longest_led_ = std::max(led_shorter * longest_led_, o.solver_smallest_step);
  }
  state_.excess = std::min(outcome.last_excess, 1.0);
  for (std::size_t d = 0; d < state_.pressure_rate.size(); ++d)
    state_.pressure_rate[d] = broke || sudden_ ? 0.0 : (pressure[d] - pressure_before_[d]) / length_;
  done_ += length_;
  double growth =
      error_ > 0.0 && !sudden_ ? 0.9 * std::sqrt(o.solver_pressure_change / error_) : longest_growth;
  // What rose like this will be at its strength then.
  if (!broke && !sudden_ && rise > 0.0) growth = std::min(growth, std::max(room / rise, shortest_cut));
  sudden_ = false;
  tried_length_ = 0.0;
  if (length_ == state_.length || growth < 1.0)
    state_.length =
        std::min(length_ * std::clamp(growth, shortest_cut, longest_growth), below_failed * stuck_length_);
  stuck_length_ *= forgetting;
}

}  // namespace hfrac
