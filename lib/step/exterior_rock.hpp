// SPDX-License-Identifier: BSD-3-Clause
// What the rock beyond the model is like (boundary.kind infinite), and where its rim rests under the far field.
//
// Both are found on a block of the same packing (step/rock_block.hpp). Brought to rest under the far field its outer discs lie where the
// far field alone takes them. From that rest they are counted: the compression of the rock under the far field does not feel the exterior,
// holes and fractures do, from the initial equilibration on. The exterior has the block's E' and nu', undrained where the model has flow:
// rock far from wells does not drain within a treatment. Given constants (boundary.exterior_modulus) are taken as given.
#pragma once

#include "build/build_model.hpp"
#include "step/engine.hpp"
#include "step/packed_model.hpp"
#include "step/rock_block.hpp"

namespace hfrac {

// Lets the exterior answer from here on. `block`: at rest under the far field, not measured yet; fills `rock`, as far as the options ask.
// nullptr: `rock` is what it told before.
void begin_exterior(Engine& engine, RockBlock* block, RockAtRest& rock, SetupReport& report);

// Rock between the outermost discs and where the pores have the formation pressure (boundary.flow_distance): a conductance behind each
// pipe to the outside, by its share of the loop's length. Together they are steady radial flow (Darcy) from the circle of the
// model's area to that distance.
void put_rock_beyond_pipes(Engine& engine, double permeability);

}  // namespace hfrac
