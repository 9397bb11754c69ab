// SPDX-License-Identifier: BSD-3-Clause
// Discs that a joint cuts loose at a hole's wall.
//
// At bonding, discs with fewer than two bonds are dropped, again and again (geom/contact_graph.hpp): nothing keeps them from turning. A smooth
// joint without bonds takes bonds away once more. In the rock, contacts of the joint and the discs around keep such a disc in its place. At the wall of
// a hole there is nothing on its other side: with one bond left it is a cantilever into the hole, which contacts that look along the
// joint's normal push out, and the joint slides by centimetres before anything is injected. In rock it would fall into the hole, and so it does here.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/faces.hpp"
#include "model/assembly.hpp"
#include "options/options.hpp"

namespace hfrac {

// After apply_joints, which leaves two bonds to what joints cut off from the rock (solid/discs_held.hpp). `holes`: the wells' faces. Discs
// next to these may be loose once they are gone.
std::vector<std::int32_t> fallen_discs(const Assembly& assembly, const std::vector<JointOptions>& joints,
                                       const Faces& faces, const std::vector<std::int32_t>& holes);

}  // namespace hfrac
