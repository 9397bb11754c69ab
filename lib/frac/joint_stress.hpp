// SPDX-License-Identifier: BSD-3-Clause
// What the contacts of joints bear in rock that the far field loads evenly, before anything has slipped: the stress of a plate
// with the model's holes (holed_plate.hpp) on their planes, less the pressure in the joint.
//
// A packing at rest under an even far field carries it unevenly: over 8 R along a joint normal stress scatters by 8 to 16 % and
// shear by 22 to 50 % (tests/verification/V23, three packings), as much as a joint that is critically stressed lacks to slip.
// So joints that conduct are held while the far field is put on, start from this stress, and slip, where it makes them,
// afterwards (step/initial_equilibration.cpp).
#pragma once

#include <vector>

#include "model/model.hpp"
#include "solid/smooth_joints.hpp"

namespace hfrac {

// One per contact of `model.assembly.smooth`. Between walls the far field is not known: there it is the mean of what the contacts of a
// joint bear within 4 R.
std::vector<JointStress> stress_on_joints(const Model& model, const Options& options, bool walled);

}  // namespace hfrac
