// SPDX-License-Identifier: BSD-3-Clause
// The tangent of a bond's answer against differences of its force.
#pragma once

#include <gtest/gtest.h>

#include "equilibrium/bond_response.hpp"
#include "model/assembly.hpp"

namespace testing_unit {

// By central differences of `step` [m, rad]; `within` [N/m].
inline void expect_tangent(hfrac::Assembly& a, const hfrac::Options& o, std::int64_t bond, double step,
                           double within) {
  const auto i = a.first[bond], j = a.second[bond];
  const hfrac::BondResponse at = respond(a, o, bond);
  double* unknown[4] = {&a.ux[j], &a.uy[j], &a.rotation[i], &a.rotation[j]};
  for (int k = 0; k < 4; ++k) {
    *unknown[k] += step;
    const hfrac::BondResponse up = respond(a, o, bond);
    *unknown[k] -= 2.0 * step;
    const hfrac::BondResponse down = respond(a, o, bond);
    *unknown[k] += step;
    for (int row = 0; row < 4; ++row)
      EXPECT_NEAR(at.tangent[4 * row + k], (up.force[row] - down.force[row]) / (2.0 * step), within)
          << row << " " << k;
  }
}

}  // namespace testing_unit
