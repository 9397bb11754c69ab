// SPDX-License-Identifier: BSD-3-Clause
// The local plane of a crack: what a broken bond opens, and how long its pipe is, seen from the fracture it is part of.
//
// A fracture in a packing goes round discs, so the line of centres of one broken bond says little of the fracture's direction, and a
// fracture w wide shows gaps of w cos(angle) there. Lubrication asks for the opening across the fracture and the way along it
// (q = -w^3 / (12 eta) dp/ds). So through the middle of a broken bond, and through the pores and broken bonds that are connected with
// it through broken bonds within `reach` mean radii, a line is laid by least squares of the distances to it (principal axis). With n
// normal and t along it, A and B the pores the pipe joins,
//   opening   U = n . ((u_j - u_i) - (theta_i a_i + theta_j a_j) e_t) - (n . e_n) growth
//             the jump of the displacements of the two discs at their contact (e_n, e_t along and across the line of centres)
//   length    |t . (c_B - c_A)|, at least a tenth of R_i + R_j; at a well or outside it begins at the contact
// Which side of the line is which follows from the way: what can be reached through A lies behind, through B ahead. All from
// places at bonding and from which bonds are broken, so it is a function of the state. A bond of a joint has the joint's plane.
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

struct Assembly;
struct Network;

struct CrackPlane {
  Vec2 normal;                             // unit, towards the second disc's side; 0: the bond is intact
  double by_first = 0.0, by_second = 0.0;  // m: change of the opening by a disc's rotation
  double shrinks = 0.0;                    // of the opening, by the discs' growth
  double length = 0.0;                     // m, of the pipe
};

class CrackPlanes {
 public:
  // From now on planes are kept.
  void begin(const Network& network, const Assembly& assembly);
  [[nodiscard]] bool kept() const { return !planes_.empty(); }

  // Follows what broke, or came back by a restore, since the last time. Looks around those places only.
  void refresh(const Network& network, const Assembly& assembly);

  // Of a broken bond; nullptr where there is none.
  [[nodiscard]] const CrackPlane* of(std::size_t bond) const {
    return planes_.empty() || (planes_[bond].normal.x == 0.0 && planes_[bond].normal.y == 0.0)
               ? nullptr
               : &planes_[bond];
  }
  // Opening across the plane [m], negative where the faces are pressed together.
  static double opening(const CrackPlane& plane, const Assembly& assembly, std::size_t bond);

 private:
  [[nodiscard]] CrackPlane fit(const Network& network, const Assembly& assembly, std::int32_t bond);
  [[nodiscard]] Vec2 middle(const Assembly& assembly, std::int32_t bond) const;

  std::vector<CrackPlane> planes_;                  // per bond
  Array<std::uint8_t> intact_;                      // as planes_ know it
  std::vector<std::int32_t> broken_;                // ascending
  std::vector<std::int32_t> pipe_start_, pipe_of_;  // pipes of each domain
  struct Visit {
    std::int32_t domain;
    double side;
  };
  std::vector<Visit> queue_;
  std::vector<std::int32_t> bonds_, domains_;  // of a search: seen
};

// Length of a pipe [m]: of its piece of a joint that conducts, along the crack's plane where there is one, else R_i + R_j.
double pipe_length(const Network& network, const Assembly& assembly, std::size_t pipe);

}  // namespace hfrac
