// SPDX-License-Identifier: BSD-3-Clause
// Discs that a smooth joint leaves with a single bond on their own side belong to the other side.
//
// A disc on one bond turns about it: contacts that look along the joint's normal push it off its middle, and its piece of the joint slides
// many times as far as the pieces beside it. Across the joint it has more bonds. So the joint is led around it: the bonds that the joint
// crossed stay rock, and the joint crosses the single one instead, though its line does not. The contact there lies on the line, at the
// foot of where the two discs meet, and looks along the joint's normal as the others do.
//
// The next disc on its own side may be left with one bond by that, and follows; or, if it cannot, the first one stays. It stays, too, at a joint's
// ends, which would be shorter, and where joints meet: led around a disc there, a joint would miss the other one's end.
//
// A disc with one bond on either side is as loose whichever side it belongs to. Its contact is idle: the contacts beside it share its piece.
#pragma once

#include <cstdint>
#include <vector>

#include "model/assembly.hpp"
#include "options/options.hpp"

namespace hfrac {

struct MovedDisc {
  std::int32_t disc, joint;  // that cut it off from its own side
};

struct DiscsOnOneBond {
  std::vector<MovedDisc> moved;    // ascending by disc
  std::vector<std::int64_t> idle;  // bonds whose contacts are; ascending
};

// `joint_of`: the joint that crosses each bond, or -1, as those bonds are from here on.
DiscsOnOneBond move_discs_on_one_bond(const Assembly& assembly, const std::vector<JointOptions>& joints,
                                      std::vector<std::int32_t>& joint_of);

}  // namespace hfrac
