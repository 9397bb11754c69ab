// SPDX-License-Identifier: BSD-3-Clause
// The seismic catalogue: cracks that broke together as one event, how strong it was, and how strong events are spread.
//
// Clustering after Hazzard and Young (2000, Int. J. Rock Mech. Min. Sci. 37, 867-872; 2004, ibid. 41, 1365-1376): a
// crack's source region reaches one disc diameter around it, and cracks whose regions overlap while they are active
// are one event. Here: two cracks are linked if their middles are at most `distance` apart and they broke at most
// `time_window` and `cycle_window` apart; linked cracks, over any number of links, are an event.
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

#include "core/array.hpp"

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
  double distance = 0.0;          // m; 0: twice the mean distance between the discs of the cracks
  double time_window = 0.0;       // s; 0: the same step
  std::int64_t cycle_window = 0;  // mechanical cycles; 0: no limit
  double thickness = 1.0;         // m, of the slice of rock that the plane stands for
};

struct SeismicEvent {
  std::int64_t first_crack = 0, crack_count = 0, tensile_cracks = 0;
  std::int64_t first_cycle = 0, last_cycle = 0;
  double time = 0.0;                    // s, of its first crack
  Vec2 position{};                      // m, middle of its cracks
  double xx = 0.0, yy = 0.0, xy = 0.0;  // N m, moment tensor, outward positive
  double moment = 0.0;                  // N m, scalar
  double magnitude = 0.0;               // of the moment
  double energy = 0.0;                  // J, elastic, of the bonds that broke
  double energy_magnitude = 0.0;
  double isotropic_fraction = 0.0;  // -1 to 1
  double length = 0.0;              // m, of its cracks, summed
  double radius = 0.0;              // m, from its position to the farthest of them
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
