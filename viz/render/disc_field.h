// SPDX-License-Identifier: BSD-3-Clause
// A quantity on the discs, ready to be coloured.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "page.h"
#include "snapshot.h"

namespace hfrac::viz {

// Each disc's value becomes the mean over the discs within `radius` [m], large and near ones counting most:
// the stress of a single disc of a packing says little, that of its neighbourhood does.
std::vector<double> smoothed(const Discs& discs, std::span<const double> values, double radius);

// The values between which nearly all visible discs lie; a few odd ones do not stretch the colour scale.
// `two_ways`: the same to both sides of zero.
std::pair<double, double> usual_range(const Discs& discs, std::span<const double> values,
                                      const Extent& extent, bool two_ways);

}  // namespace hfrac::viz
