// SPDX-License-Identifier: BSD-3-Clause
// The log of broken bonds. It only grows.
#pragma once

#include <cstdint>
#include <vector>

namespace hfrac {

enum class CrackMode : std::int32_t { tension = 1, shear = 2 };

struct Crack {
  std::int64_t bond = 0;
  std::int64_t step = 0;      // 0: during the initial equilibration
  std::int64_t cycle = 0;     // mechanical cycle since creation
  double time = 0.0;          // s
  double normal_force = 0.0;  // N at failure, tension positive; of a bond that softened: where it began to
  double shear_force = 0.0;   // N, likewise
  double energy = 0.0;        // J/m, elastic, of the bond at failure; what softening took with it
  double released = 0.0;      // J/m, lost by bond and contact together; for the balance of its step
  CrackMode mode = CrackMode::tension;
  std::int32_t fracture = -1;  // when last found
};

using CrackLog = std::vector<Crack>;

}  // namespace hfrac
