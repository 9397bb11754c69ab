// SPDX-License-Identifier: BSD-3-Clause
// Discs that are smaller than a pixel or two, as density: every pixel gets as much of the discs' colours as discs
// cover of it. Round points would leave holes and moire patterns there, and take ten times as long.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colour.h"
#include "page.h"
#include "snapshot.h"

namespace hfrac::viz {

// Red, green, blue; rows from the bottom up.
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

// On the palette's paper. `fills` has one colour for all, or one per disc. One pixel is one finished pixel of the view.
Raster disc_raster(const Discs& discs, std::span<const Colour> fills, const Extent& extent, int width,
                   int height);

}  // namespace hfrac::viz
