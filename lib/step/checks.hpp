// SPDX-License-Identifier: BSD-3-Clause
// What no step may leave behind. All throw Error(diverged) with the place and the equation.
#pragma once

#include <string>

#include "step/engine.hpp"

namespace hfrac {

// All of the below, as it applies to the solver.
void check_step(Engine& engine);

// Which number of the state is not finite, in words; empty: all are.
std::string not_finite(const Engine& engine);

// The smooth-joint law keeps the pairs of discs of the first contact; past about a radius others face each other.
void require_joints_in_reach(const Engine& engine);

// A time step too long for the model lets every cycle add energy that no work brought in (explicit solver).
void watch_energy(const Engine& engine);

}  // namespace hfrac
