// SPDX-License-Identifier: BSD-3-Clause
// A picture as the content of a PNG file.
#pragma once

#include <cstdint>
#include <vector>

#include "image.h"

namespace hfrac::viz {

// dots_per_inch: how large it is on paper, 0: not said.
std::vector<std::uint8_t> png(const Image& image, int dots_per_inch = 0);

}  // namespace hfrac::viz
