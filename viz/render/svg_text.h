// SPDX-License-Identifier: BSD-3-Clause
// What VTK's SVG exporter leaves to be mended.
#pragma once

#include <string>

#include "colour.h"

namespace hfrac::viz {

// The same picture with a view box, so that it scales to any page, with paper behind it, and without its clip
// rectangles: VTK counts theirs from the wrong edge or leaves them undefined, and nothing here needs them.
std::string mended_svg(const std::string& svg, Colour paper);

// "#rrggbb"
std::string hexadecimal(Colour colour);

}  // namespace hfrac::viz
