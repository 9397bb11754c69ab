// SPDX-License-Identifier: BSD-3-Clause
// What no step may leave behind. All throw Error with the place and what to change: diverged, or collapsed for discs that left
// their places.
#pragma once

#include <string>

#include "step/engine.hpp"

namespace hfrac {

// All of the below, as it applies to the solver.
void check_step(Engine& engine);

// Which number of the state is not finite, in words; empty: all are.
std::string not_finite(const Engine& engine);

// Notes where discs are as a step begins.
void note_places(Engine& engine);
// A disc that moves by more than its diameter in one step has left the neighbours that its bonds and pores are of; sound runs move
// discs by an eighth of a diameter at most, mostly by a hundredth.
void require_discs_in_place(const Engine& engine);

// The smooth-joint law keeps the pairs of discs of the first contact; past about a radius others face each other.
void require_joints_in_reach(const Engine& engine);

// A time step too long for the model lets every cycle add energy that no work brought in (explicit solver).
void watch_energy(const Engine& engine);

}  // namespace hfrac
