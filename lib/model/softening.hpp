// SPDX-License-Identifier: BSD-3-Clause
// What softening bonds keep (bond.fracture_energy). Their law: solid/softening.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

struct Softening {
  Array<double> start;     // m per bond: opening w at which it began to soften; 0: it is whole
  Array<double> worst;     // m: largest w since, at most the one at which nothing is left of it
  std::vector<char> held;  // per bond: it neither softens nor breaks (ExplicitSolver::hold_edge); empty: none

  // No bond softens in this model.
  [[nodiscard]] bool empty() const { return start.empty(); }
  [[nodiscard]] bool holds(std::int64_t bond) const {
    return !held.empty() && held[static_cast<std::size_t>(bond)] != 0;
  }
};

}  // namespace hfrac
