// SPDX-License-Identifier: BSD-3-Clause
// The log of what smooth joints slipped. It only grows.
//
// A contact gets an entry once its slip has gone on by `logged_slip` since its last one, and no more than one for each increment
// of a step. So the entries of a contact sum up to its slip, to within that, however short the increments are, and how long the log can
// grow is ruled by how far joints slip and not by how long a run takes.
#pragma once

#include <cstdint>
#include <vector>

namespace hfrac {

// Of the mean disc diameter. With a shear modulus of 30 GPa a single contact that slipped so far lost some 0.3 MPa of shear
// stress (of the order G slip / length, Kanamori and Anderson 1975), at the lower end of what earthquakes lose.
inline constexpr double logged_slip = 1e-5;

struct Slip {
  std::int64_t bond = 0;
  std::int64_t step = 0;  // 0: during the initial equilibration
  double time = 0.0;      // s, at the end of the increment in which it was found
  double duration = 0.0;  // s, of that increment
  double slip = 0.0;      // m, since the contact's last entry; sign as Assembly::slip
};

using SlipLog = std::vector<Slip>;

}  // namespace hfrac
