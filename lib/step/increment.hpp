// SPDX-License-Identifier: BSD-3-Clause
// How long an increment of a coupled step may be.
//
// As long as three things allow: the error of backward Euler, estimated against a straight line through the increment before; no
// bond farther beyond its strength than solver.strength_overshoot before it breaks; convergence. An increment that fails one of
// them is rejected and tried again shorter, down to solver.smallest_step.
//
// Where the shortest finds no equilibrium either, damped motion leads on. A piece between cracks whose contacts slide stops and slips
// a little again and again, with nothing broken; then longer and longer increments are led on, as far as the first of the three allows,
// or a step of seconds would be one of millions of increments.
#pragma once

#include <limits>
#include <vector>

#include "step/engine.hpp"

namespace hfrac {

class IncrementControl {
 public:
  // For one step of `duration` seconds.
  IncrementControl(Engine& engine, double duration);

  [[nodiscard]] bool finished() const { return done_ >= duration_; }
  [[nodiscard]] double done() const { return done_; }  // s of the step

  // Begins the next increment and gives its length [s].
  double begin();
  [[nodiscard]] bool shortest() const { return length_ <= engine_.options.solver_smallest_step; }
  // Stress over strength beyond which the increment is not to be kept.
  [[nodiscard]] double most_excess() const;
  // Whether damped motion leads on from an increment as short as this one that found no equilibrium.
  [[nodiscard]] bool leads_on() const { return length_ <= longest_led_; }
  // It did, and the increment is to be kept: what pressures were heading for says nothing any more.
  void was_led_on();
  // It did not come to rest either: from now on the shortest alone is led on.
  void was_not_led_on();

  // Whether an increment that ended like this is kept.
  [[nodiscard]] bool accepts(const EquilibriumSolver::Outcome& outcome);
  // After the state was put back: what to count it as, and the length to try next.
  void reject(const EquilibriumSolver::Outcome& outcome);
  // After it was kept.
  void accept(const EquilibriumSolver::Outcome& outcome);

 private:
  [[nodiscard]] double error() const;
  void found_no_rest();

  Engine& engine_;
  IncrementState& state_;
  double duration_, done_ = 0.0, length_ = 0.0;
  double error_ = 0.0;  // of backward Euler in the increment at hand
  std::size_t cracks_before_ = 0;
  double tried_length_ = 0.0, tried_rise_ = 0.0;
  double stuck_length_ = std::numeric_limits<double>::infinity();
  double longest_led_;    // s
  int without_rest_ = 0;  // increments without one since something broke
  bool sudden_ = false;
  std::vector<double> pressure_before_;  // Pa per domain
};

}  // namespace hfrac
