// SPDX-License-Identifier: BSD-3-Clause
// What the rock beyond the model is like (boundary.kind infinite), and where its rim rests under the far field.
//
// Both are found on a block: the same packing without holes, joints and strengths to exceed, on the stress boundary, drained. Brought to
// rest under the far field its outer discs lie where the far field alone takes them. From that rest they are counted: the compression of the
// rock under the far field does not feel the exterior, holes and fractures do, from the initial equilibration on. The block's strain
// under a little more stress along x and along y, over the inner 70 % of its sides, gives E' and nu'. Where the model has flow, rock far from wells
// does not drain within a treatment, and the exterior is taken undrained (Rice and Cleary 1976, Rev. Geophys. Space Phys. 14, 227-241), with plane-strain
// moduli
//   K_u = K + alpha^2 M,   E'_u = 4 G K_u / (K_u + G),   nu'_u = (K_u - G) / (K_u + G)
// Given constants (boundary.exterior_modulus) are taken as given.
#pragma once

#include "build/build_model.hpp"
#include "step/engine.hpp"

namespace hfrac {

// Lets the exterior answer from here on. `packing`: the model's, before wells were cut. Throws Error(collapsed) if the block finds no rest.
void begin_exterior(Engine& engine, const CaseDefinition& definition, Packing packing, SetupReport& report);

// Rock between the outermost discs and where the pores have the formation pressure (boundary.flow_distance): a conductance behind each
// pipe to the outside, by its share of the loop's length. Together they are steady radial flow (Darcy) from the circle of the
// model's area to that distance.
void put_rock_beyond_pipes(Engine& engine, double permeability);

}  // namespace hfrac
