// SPDX-License-Identifier: BSD-3-Clause
// A rose of directions: lines have no sense, so each is counted in one of equal bins over half a circle and drawn to both sides. 0 degrees
// is the x axis, counter-clockwise.
#pragma once

#include <string>
#include <vector>

#include "chart_page.h"

namespace hfrac::viz {

// Of each bin, from 0 to 180 degrees, the length of lines of each kind [m].
using RoseBins = std::vector<std::vector<double>>;

struct RoseScale {
  double longest = 1;  // bin [m]
  std::string ring;    // [m] from ring to ring
};

// Kinds are stacked from the centre out, each in its colour.
RoseScale put_rose(ChartPage& page, Point centre, double radius, const RoseBins& bins,
                   const std::vector<Colour>& colours);

}  // namespace hfrac::viz
