// SPDX-License-Identifier: BSD-3-Clause
// The fluid in a joint that conducts (JointLaw::conducts).
//
// The pores that a joint's contacts lie between become its own. Each contact of length A (its piece of the joint) belongs to either
// pore by half, and there
//   stores    A / 2 e_0 at K_f (Network::storing; the packing's pore stays its volume), what the pore grows by as the joint opens, and
//             A / 2 S p of a joint with a storage S: pores and small fractures beside it, which take in fluid and move nothing
//   conducts  w^3 / (12 eta A) along the joint, w of its opening (joint_aperture); voids between pieces count, too, and
//             pieces below 0.05 R as much as that, all others less for it
//   pushes    p A / 2 on both discs along the joint's normal, where the contact lies, so with a moment (Network::corner_turn), and
//             with the whole pressure, whatever rock.biot_coefficient is: faces touch at few places only. So what the contact
//             bears is the effective stress: where fluid takes over what it bore nothing moves.
//   grows     by A / 2 U_n, the work-conjugate of that push.
// On the rock beside the joint its pores do not push. Between joint and rock fluid passes through the pipes of the bonds around
// such a pore, as tight as the rock.
#pragma once

#include <cstdint>

#include "model/network.hpp"
#include "options/options.hpp"

namespace hfrac {

// Right after the network is built. Nothing without joints that conduct.
void begin_joint_pores(Network& network, const Assembly& assembly, const Options& options);

// Adds the push on the faces of a joint's contacts to the weights of a domain's corners.
void add_face_weights(Network& network, const Assembly& assembly, std::int32_t domain);

// Whether a smooth joint that holds no more passes through a pore: a fracture that ends in it ends at the joint and has no tip there.
bool joint_passes(const Network& network, const Assembly& assembly, std::int32_t domain);

// Piece of a joint that a pipe runs along [m]; 0: none that conducts.
inline double joint_length(const Network& n, std::size_t pipe) {
  return n.joint_length.empty() ? 0.0 : n.joint_length[pipe];
}

// The broken contact by whose opening fluid flows through a pipe of a joint that conducts; nullptr: of any other pipe.
inline const SmoothContact* flowing_contact(const Network& n, const Assembly& a, std::size_t pipe) {
  if (joint_length(n, pipe) <= 0.0) return nullptr;
  const auto at = a.smooth.opening_at(static_cast<std::int64_t>(pipe));
  const SmoothContact* contact = at < 0 ? nullptr : &a.smooth.contacts[static_cast<std::size_t>(at)];
  return contact != nullptr && a.intact[contact->bond] == 0 ? contact : nullptr;
}

}  // namespace hfrac
