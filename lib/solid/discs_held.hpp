// SPDX-License-Identifier: BSD-3-Clause
// Discs that smooth joints cut off from the rock keep some of the bonds that a joint crosses.
//
// Where joints meet, a disc that they cut off on all sides but one has nothing that keeps it from turning: contacts that look along a
// joint's normal bear it off its middle. And a disc that joints cut off, or a few that are bonded to each other only, are too small a piece of
// rock: those that a single joint cuts off have no neighbours on their side of it, and float away as it opens until they lie on other discs.
// They are left to the other side, so where the joint slides the discs they come to on their own side are across it. So are, before that, those
// that a joint leaves with a single bond (solid/discs_on_one_bond.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "model/assembly.hpp"
#include "options/options.hpp"
#include "solid/discs_on_one_bond.hpp"

namespace hfrac {

struct KeptBond {
  std::int64_t bond;
  std::int32_t joint;  // that crosses it
};

struct HeldDiscs {
  std::vector<KeptBond> kept;
  std::vector<MovedDisc> moved;  // ascending by disc
  std::vector<std::int64_t>
      idle;  // bonds that joints cross and whose contacts bear next to nothing; ascending
};

// `joint_of`: the joint that crosses each bond, or -1, as those bonds are from here on.
HeldDiscs keep_discs_held(const Assembly& assembly, const std::vector<JointOptions>& joints,
                          std::vector<std::int32_t>& joint_of);

}  // namespace hfrac
