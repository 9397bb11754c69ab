// SPDX-License-Identifier: BSD-3-Clause
// What sets a bond apart from the next where the rock is not the same everywhere.
//
// Four things do: strength that follows disc size (toughness.hpp), joints (joints.hpp), temperature (lib/heat), and bonds that soften
// (softening.hpp), which start where these strengths say. Each keeps its own numbers; here they are multiplied, once when one of them changes, so that the law of a bond reads one set of arrays. In
// a rock that is the same everywhere the arrays are empty and the law does without.
#pragma once

#include <cstdint>

#include "core/array.hpp"

namespace hfrac {

constexpr double never_breaks = 1e200;  // of the strength

struct BondFactors {
  Array<double> growth;          // m, that the two discs' thermal growth takes from the gap
  Array<double> stiffness;       // over the stiffnesses given, of bond and contact
  Array<double> tensile, shear;  // over the strengths given
  Array<double> friction;        // the coefficient itself

  [[nodiscard]] bool empty() const { return tensile.empty(); }
  [[nodiscard]] double growth_of(std::int64_t bond) const { return empty() ? 0.0 : growth[bond]; }
  [[nodiscard]] double stiffness_of(std::int64_t bond) const { return empty() ? 1.0 : stiffness[bond]; }
  [[nodiscard]] double tensile_of(std::int64_t bond) const { return empty() ? 1.0 : tensile[bond]; }
  [[nodiscard]] double shear_of(std::int64_t bond) const { return empty() ? 1.0 : shear[bond]; }
  [[nodiscard]] double friction_of(std::int64_t bond, double elsewhere) const {
    return empty() ? elsewhere : friction[bond];
  }
};

struct Assembly;
struct Options;

// Fills assembly.factors from its toughness, joints and temperature. To be called when any of them has changed.
void combine_factors(Assembly& assembly, const Options& options);
// Likewise where the rock is the same everywhere, for single ones to be changed then.
void refill_factors(Assembly& assembly, const Options& options);

}  // namespace hfrac
