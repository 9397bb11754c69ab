// SPDX-License-Identifier: BSD-3-Clause
#include "image.h"

#include <algorithm>
#include <array>

namespace hfrac::viz {
namespace {

// Sums of `factor` drawn rows first, then of `factor` neighbours in them: the first loop runs over whole vectors.
template <unsigned factor>
void reduce(const std::uint8_t* bottom_up_rgb, Image& image) {
  const std::size_t row = static_cast<std::size_t>(image.width) * factor * 3;
  std::vector<std::uint16_t> sums(row);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* source =
        bottom_up_rgb + static_cast<std::size_t>(image.height - 1 - y) * factor * row;
    for (std::size_t i = 0; i < row; ++i) {
      unsigned sum = 0;
      for (unsigned k = 0; k < factor; ++k) sum += source[k * row + i];
      sums[i] = static_cast<std::uint16_t>(sum);
    }
    const std::uint16_t* from = sums.data();
    std::uint8_t* target = image.row(y);
    for (int x = 0; x < image.width; ++x, from += 3 * factor, target += 3) {
      for (unsigned colour = 0; colour < 3; ++colour) {
        unsigned sum = factor * factor / 2;
        for (unsigned k = 0; k < factor; ++k) sum += from[3 * k + colour];
        target[colour] = static_cast<std::uint8_t>(sum / (factor * factor));
      }
    }
  }
}

}  // namespace

Image reduced(const std::uint8_t* bottom_up_rgb, int width, int height, int factor) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  static constexpr std::array reductions = {reduce<1>, reduce<2>, reduce<3>};
  reductions[static_cast<std::size_t>(std::clamp(factor, 1, 3) - 1)](bottom_up_rgb, image);
  return image;
}

}  // namespace hfrac::viz
