// SPDX-License-Identifier: BSD-3-Clause
// How much of the second fluid is in the rock [m2]: what the books have to say came in and did not leave.
#pragma once

#include "model/network.hpp"

namespace testing_unit {

inline double second_fluid_in_rock(const hfrac::Network& n) {
  double all = 0.0;
  for (std::size_t d = 1; d < n.second_content.size(); ++d) all += n.is_own(d) ? n.second_content[d] : 0.0;
  return all;
}

}  // namespace testing_unit
