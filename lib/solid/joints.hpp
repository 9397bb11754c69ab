// SPDX-License-Identifier: BSD-3-Clause
// Joints: straight lines along which the rock is weaker than elsewhere, or broken from the start (natural fractures, bedding).
//
// A joint takes the bonds it crosses: those whose two disc centres lie on different sides of it, with the line between them
// meeting the joint between its ends. These get its strengths and its friction; where joints cross, the later one in the
// definition counts. A joint of a packing is therefore as rough as the packing: the contacts along it look up to some 40
// degrees away from its normal, so that it slides with more resistance than its coefficient of friction says, and opens as it
// slides. On a square grid of discs (packing.method "square") a joint along a row is smooth. Fluid is spared that roughness: the
// pipes of a broken joint are as wide as the joint opens across its line, though a contact that lies along it may be pressed.
// Joints whose state says so are smooth in any packing and at any angle (smooth_joints.hpp).
//
// Bonds of a broken joint stand in the crack log as cracks of the set-up, in shear and without energy.
#pragma once

#include <vector>

#include "model/assembly.hpp"
#include "model/crack_log.hpp"
#include "options/options.hpp"

namespace hfrac {

// Right after bonding. Returns how many joints are left out: smooth ones shorter than two discs, and any that cross no bond.
std::int64_t apply_joints(Assembly& assembly, const std::vector<JointOptions>& joints, const Options& options,
                          CrackLog& log);

}  // namespace hfrac
