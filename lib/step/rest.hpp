// SPDX-License-Identifier: BSD-3-Clause
// How the rock comes to rest, or moves: the stage of a step in which bonds break.
#pragma once

#include <string>

#include "step/engine.hpp"

namespace hfrac {

struct RestOutcome {
  bool stopped = false;
};

// Rest under the pressures as they are, pores undrained: by damped motion, or (solver.kind = "quasi-static") by solving for it.
RestOutcome find_rest(Engine& engine, const Interrupt& interrupt);

// `duration` seconds of motion in real time, pores undrained.
RestOutcome move_rock(Engine& engine, double duration, const Interrupt& interrupt);

// Fractures of facets go on from tips that the openings behind them ask to (frac/tip.hpp), the farthest beyond first and none beside another.
// Whether any did.
bool grow_tips(Engine& engine, CrackLog& log);

// Where the quasi-static solver finds no equilibrium: damped motion leads on from the state as it stands, after fluid has flowed for
// `increment` seconds, and equilibrium is solved for where it ends.
EquilibriumSolver::Outcome relax_dynamically(Engine& engine, double increment, const Interrupt& interrupt);

// EquilibriumSolver::solve, but that an equilibrium softening rock has no energy for counts as none.
EquilibriumSolver::Outcome solve_soundly(Engine& engine, double duration, const std::vector<double>& source,
                                         double most_excess, const Interrupt& interrupt);

// Keeps account of what the quasi-static solver did.
void count(Engine& engine, const EquilibriumSolver::Outcome& outcome);

// "(x, y) m", rounded.
std::string place_text(Vec2 at);

}  // namespace hfrac
