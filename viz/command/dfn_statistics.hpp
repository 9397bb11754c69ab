// SPDX-License-Identifier: BSD-3-Clause
// A discrete fracture network from statistics and a seed.
//
// A set of fractures has
//   directions   the mean, turned by half of an angle of von Mises's distribution with a concentration (lines have no sense: axial;
//                Mardia and Jupp 2000). 0: all directions alike
//   lengths      a density ~ length^-exponent between the shortest and the longest (Bonnet et al. 2001), or lognormal by median and the
//                standard deviation of the logarithm, of which what lies outside shortest and longest is drawn again
//   middles      anywhere in the model
// and is made trace by trace, in turn with the other sets, until its length per area, P21, is reached. What sticks out of the model is
// cut off. The same seed gives the same traces on any platform.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command/dfn_traces.hpp"

namespace hfrac::command {

struct FractureSet {
  double direction = 0.0;                ///< [deg] from x, counter-clockwise
  double concentration = 0.0;            ///< [1]
  double p21 = 0.0;                      ///< [1/m]
  double exponent = 0.0;                 ///< [1] of the power law
  double median = 0.0;                   ///< [m] of the lognormal law; 0: power law
  double deviation = 0.0;                ///< [1] of the logarithm of the lengths
  double shortest = 0.0, longest = 0.0;  ///< [m]
  double t_share =
      0.0;  ///< [1] of the traces that meet earlier ones, the share that ends on the nearest of them
};

/** Throws BadInput with the value, its range and what to do. `name`: of the set in the sentence. */
void check_set(const FractureSet& set, const std::string& name);

/** A set by its keys: "direction=30,concentration=8,p21=0.05,exponent=2.5,shortest=8,longest=50". Throws BadInput. */
FractureSet set_of(const std::string& text, size_t number);

/** Share of a set's fractures that are at least `length` [m] long, before they are cut. */
double longer_share(const FractureSet& set, double length);

struct NetworkPlan {
  std::vector<FractureSet> sets;
  Frame frame;
  std::optional<Place> through;  ///< the first trace of each set goes through it, with the longest length
  uint64_t seed = 1;
};

/** Throws BadInput if that takes more than 100 000 traces. */
std::vector<Trace> make_network(const NetworkPlan& plan);

}  // namespace hfrac::command
