// SPDX-License-Identifier: BSD-3-Clause
// A well added to a living simulation: the pore of the rock nearest to a point takes or gives fluid where it lies. No hole is cut and
// nothing is renumbered: the pore stays one of the rock, with its storage and what it pushes with, and so does every field, image and
// view a host holds. The well is part of the state.
#pragma once

#include <cstddef>

#include "step/simulation.hpp"

namespace hfrac {

// Shut in until it is driven (impose.hpp), so that adding it changes nothing. Returns its number. Throws Error(argument) where no pore of
// the rock is to be had: without fluid, outside the rock, in another well, while a step is open.
std::size_t add_well(Simulation& simulation, Vec2 at);

}  // namespace hfrac
