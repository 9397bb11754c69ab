// SPDX-License-Identifier: BSD-3-Clause
// The seismic catalogue: cracks that broke together as one event, how strong it was, and how strong events are spread.
//
// Which cracks are one event: frac/linking.hpp.
//
// Moment after Hazzard and Young (2002, Tectonophysics 356, 181-197): the sum of force change times lever arm. The
// forces that change are those of the bonds that broke, and each falls to nothing. A bond that pulled disc 1 with -F
// and disc 0 with F acts, when gone, as the couple of the opposite forces at the two centres, d n apart:
//   m_ij = d/2 (F_i n_j + F_j n_i),   F = normal force n + shear force t,   t = n turned by +90 degrees.
// (Its antisymmetric part is balanced by the moments on the discs.) What discs around the break shift afterwards, and
// what contacts take over, is not in it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frac/linking.hpp"
#include "frac/seismic_event.hpp"

namespace hfrac {

// A crack as the catalogue needs it.
struct CatalogueCrack {
  Vec2 position, normal;                         // m; from first to second disc
  double distance = 0.0;                         // m, between the centres of its discs
  double normal_force = 0.0, shear_force = 0.0;  // N per metre of thickness, at failure
  double energy = 0.0;                           // J/m
  double length = 0.0;                           // m
  double time = 0.0;                             // s
  std::int64_t cycle = 0;
  bool tensile = true;
};

struct CatalogueRule {
  LinkRule link{};
  double thickness = 1.0;  // m, of the slice of rock that the plane stands for
};

// In order of the first crack. event_of: the event of each crack.
std::vector<SeismicEvent> find_events(std::span<const CatalogueCrack> cracks, const CatalogueRule& rule,
                                      std::vector<std::int64_t>& event_of);

// log10 N = a - b M of Gutenberg and Richter, above `completeness`.
struct MagnitudeLaw {
  double completeness = 0.0;
  double b = 0.0, b_error = 0.0;  // 0: fewer than two different magnitudes
  double a = 0.0;
  std::int64_t count = 0;  // of the events from `completeness` on
};

// `completeness` NaN: the fullest tenth of a magnitude.
MagnitudeLaw magnitude_law(std::span<const double> magnitudes, double completeness);

}  // namespace hfrac
