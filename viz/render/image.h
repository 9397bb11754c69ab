// SPDX-License-Identifier: BSD-3-Clause
// A finished picture in memory: 8-bit red, green, blue, rows from the top down.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hfrac::viz {

struct Image {
  int width = 0;   // [pixel]
  int height = 0;  // [pixel]
  std::vector<std::uint8_t> rgb;

  std::uint8_t* row(int y) { return rgb.data() + static_cast<std::size_t>(y) * width * 3; }
  const std::uint8_t* row(int y) const { return rgb.data() + static_cast<std::size_t>(y) * width * 3; }
};

// From pixels drawn `factor` (1, 2 or 3) times too large in both directions, rows from the bottom up: every pixel is the
// mean of factor x factor drawn ones, which smooths every edge alike, discs and text included.
Image reduced(const std::uint8_t* bottom_up_rgb, int width, int height, int factor);

// A picture as the content of a PNG file.

// dots_per_inch: how large it is on paper, 0: not said.
std::vector<std::uint8_t> png(const Image& image, int dots_per_inch = 0);

}  // namespace hfrac::viz
