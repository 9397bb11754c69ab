// SPDX-License-Identifier: BSD-3-Clause
// Bonds that stay because too small a piece of rock would come loose.
//
// A disc that no bond holds is a grain smaller than the model resolves. In a fracture the fluid pushes it into the next constriction,
// where it bears on both faces and closes the pipes around it, which no grain of rock does to a fracture wider than itself, and
// an equilibrium of its own it does not have. So a bond does not break if that would cut fewer than bond.smallest_fragment discs
// from the rest: the piece stays on one face of the fracture, held by one bond, which can bear nothing but what acts on the
// piece itself. With fracture.law facet no piece of fewer than 64 discs comes loose: its facets do not keep it where it is. Nor, in
// a model with joints that conduct, one of up to `largest_flake`: fluid pushes it out of a joint that opens.
#pragma once

#include <cstdint>
#include <vector>

#include "options/options.hpp"

namespace hfrac {

struct Assembly;

class Fragments {
 public:
  Fragments(const Assembly& assembly, const Options& options);

  [[nodiscard]] bool kept() const { return smallest_ > 1; }
  // Whether one of the bond's discs would be left in a piece that is too small. Looks at intact bonds of the discs near it.
  [[nodiscard]] bool would_cut(const Assembly& assembly, std::int64_t bond) const {
    return kept() && would_cut(assembly, bond, smallest_);
  }
  // Whether it is the last bond of one of its discs: all that is asked on the way by motion. Looks at those two discs' bonds
  // only, as workers have to that move tiles side by side.
  [[nodiscard]] bool is_last(const Assembly& assembly, std::int64_t bond) const {
    return kept() && would_cut(assembly, bond, 2);
  }

  static constexpr std::int64_t most = 64;
  // Discs; as few that joints cut off are no rock of their own, neither at bonding (discs_held.hpp) nor later.
  static constexpr std::int64_t largest_flake = 8;

 private:
  [[nodiscard]] bool would_cut(const Assembly& assembly, std::int64_t bond, std::int64_t smallest) const;
  [[nodiscard]] bool small(const Assembly& assembly, std::int32_t from, std::int64_t without,
                           std::int64_t smallest) const;

  std::int64_t smallest_;
  std::vector<std::int32_t> bond_start_, bond_of_;  // bonds of each disc
};

}  // namespace hfrac
