// SPDX-License-Identifier: BSD-3-Clause
// What a contact of a smooth joint is seen to do: where its piece of the joint lies now, how far it is open, what it slid and
// bears.
//
// Stresses are those of the joint's law (model/joint_law.hpp), so effective ones: fluid pressure has been taken off. What settle_smooth
// left on the two discs beyond the stress that the contact starts from is not among them. Slide, and with it slip and shear stress, are positive
// where the far side moves to the left for who looks across the joint; that is so from either side.
#pragma once

#include "model/network.hpp"
#include "options/options.hpp"

namespace hfrac {

enum class JointContactState : std::int32_t { holds = 0, sticks = 1, slips = 2, open = 3 };

struct JointView {
  Vec2 begin, end;                     // m, of the piece now, halfway between the two faces
  double opening;                      // m, U_n; negative: faces pressed together
  double mechanical_aperture;          // m, e
  double hydraulic_aperture;           // m, w: that of the contact's pipe at the end of the last step
  double slip;                         // m, since the end of the initial equilibration
  double total_slip;                   // m, since bonding: friction and dilation go by it
  double normal_stress, shear_stress;  // Pa; compression positive
  double pressure;                     // Pa, mean of the pores on the contact's left and right
  JointContactState state;             // slips: all that friction bears is used up
};

JointView view_joint(const Assembly& assembly, const Network& network, const SmoothContact& contact);

}  // namespace hfrac
