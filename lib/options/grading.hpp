// SPDX-License-Identifier: BSD-3-Clause
// How large the discs of a packing are by place: fine where a fracture goes, coarser outwards.
//
// Discs are fine within a distance of a line through every well (or the model's centre), which lies as fractures do: along x unless
// told otherwise. From there on the mean radius grows by so much per metre, up to `coarsening` times that of the fine discs:
//   R(d) = min( coarsening R_f, R_f + growth max(0, d - half width) )
// with d the distance to the nearest line. R_f follows from the number of discs: with n = (1 - porosity) / (pi R^2 m) discs per area, where
// m is the mean square of radii over the square of their mean,
//   disc_count = (1 - porosity) / (pi m) * integral of 1 / R^2 over the model.
// The same spread of sizes around R everywhere makes the packing similar to itself everywhere. Bonds have stiffnesses in N/m per
// metre of thickness, and a plane assembly of discs with such bonds has no length but their radii, so its E' and nu' do
// not depend on R (dimensional analysis; measured in docs/verification/V28.md).
#pragma once

#include <vector>

#include "core/array.hpp"
#include "options/options.hpp"

namespace hfrac {

struct Grading {
  double fine = 0.0;  // m, mean radius in the fine region
  double coarsening = 1.0, growth = 0.0;
  double half_width = 0.0;  // m
  double half_length = 0.0;
  Vec2 along;                 // unit, of the lines
  std::vector<Vec2> centres;  // of the lines; none: the same size everywhere

  [[nodiscard]] bool graded() const { return !centres.empty(); }
  // To the nearest line [m].
  [[nodiscard]] double distance(Vec2 place) const;
  // Mean radius around a place [m].
  [[nodiscard]] double at(Vec2 place) const;
  [[nodiscard]] bool is_fine(Vec2 place) const { return distance(place) <= half_width; }
  [[nodiscard]] double coarsest() const { return coarsening * fine; }
};

// What the definition's packing is asked to be; uniform: of mean radius `fine` everywhere.
Grading grading_of(const CaseDefinition& definition);

}  // namespace hfrac
