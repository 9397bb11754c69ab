// SPDX-License-Identifier: BSD-3-Clause
// Each worker takes a band of rows and all discs that touch it, so nothing is written twice and the picture does not
// depend on how many there are. A disc below a pixel is spread over the four pixels around its centre, its area
// divided as the distances say; a larger one covers the inner pixels wholly and those at its edge in part.
#include "disc_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

namespace hfrac::viz {
namespace {

constexpr double smallest_round = 0.75;  // [pixel] radius from which a disc has a shape

struct Cover {
  float red = 0;
  float green = 0;
  float blue = 0;
  float area = 0;  // [pixel^2]
};

class Band {
 public:
  Band(int width, int first_row, int end_row)
      : width_(width),
        first_(first_row),
        end_(end_row),
        cover_(static_cast<std::size_t>(width) * (end_row - first_row)) {}

  void add(double x, double y, double radius, Colour colour) {
    const double reach = std::max(radius, 1.0) + 1;
    if (y + reach < first_ || y - reach > end_ || x + reach < 0 || x - reach > width_) return;
    if (radius < smallest_round) {
      add_speck(x - 0.5, y - 0.5, std::acos(-1.0) * radius * radius, colour);
    } else {
      add_round(x, y, radius, colour);
    }
  }

  void write(Raster& raster, Colour paper) const {
    std::uint8_t* pixel = raster.rgb.data() + static_cast<std::size_t>(first_) * width_ * 3;
    for (const Cover& cover : cover_) {
      // Where discs overlap they share the pixel, where they leave room the paper fills it.
      const float part = 1 / std::max(1.0F, cover.area);
      const float rest = std::max(0.0F, 1 - cover.area);
      pixel[0] = static_cast<std::uint8_t>(cover.red * part + rest * paper.red + 0.5F);
      pixel[1] = static_cast<std::uint8_t>(cover.green * part + rest * paper.green + 0.5F);
      pixel[2] = static_cast<std::uint8_t>(cover.blue * part + rest * paper.blue + 0.5F);
      pixel += 3;
    }
  }

 private:
  void put(int column, int row, double area, Colour colour) {
    if (column < 0 || column >= width_ || row < first_ || row >= end_ || !(area > 0)) return;
    Cover& cover = cover_[static_cast<std::size_t>(row - first_) * width_ + column];
    const auto weight = static_cast<float>(area);
    cover.red += weight * colour.red;
    cover.green += weight * colour.green;
    cover.blue += weight * colour.blue;
    cover.area += weight;
  }

  void add_speck(double x, double y, double area, Colour colour) {
    const double column = std::floor(x);
    const double row = std::floor(y);
    const double right = x - column;
    const double upper = y - row;
    const int i = static_cast<int>(column);
    const int j = static_cast<int>(row);
    put(i, j, area * (1 - right) * (1 - upper), colour);
    put(i + 1, j, area * right * (1 - upper), colour);
    put(i, j + 1, area * (1 - right) * upper, colour);
    put(i + 1, j + 1, area * right * upper, colour);
  }

  void add_round(double x, double y, double radius, Colour colour) {
    const int lowest = std::max(first_, static_cast<int>(std::floor(y - radius - 0.5)));
    const int highest = std::min(end_ - 1, static_cast<int>(std::floor(y + radius + 0.5)));
    for (int row = lowest; row <= highest; ++row) {
      const double dy = row + 0.5 - y;
      const double half = std::sqrt(std::max(0.0, (radius + 0.5) * (radius + 0.5) - dy * dy));
      const int from = std::max(0, static_cast<int>(std::floor(x - half)));
      const int to = std::min(width_ - 1, static_cast<int>(std::floor(x + half)));
      for (int column = from; column <= to; ++column) {
        const double distance = std::hypot(column + 0.5 - x, dy);
        put(column, row, std::clamp(radius + 0.5 - distance, 0.0, 1.0), colour);
      }
    }
  }

  int width_;
  int first_;
  int end_;
  std::vector<Cover> cover_;
};

}  // namespace

Raster disc_raster(const Discs& discs, std::span<const Colour> fills, const Extent& extent, int width,
                   int height) {
  Raster raster{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  const double across = width / extent.width;
  const double up = height / extent.height;
  const Colour paper = palette().paper;
  const bool single = fills.size() < discs.discs.size();
  const auto draw = [&](int first_row, int end_row) {
    Band band(width, first_row, end_row);
    for (std::size_t i = 0; i < discs.discs.size(); ++i) {
      const Disc& disc = discs.discs[i];
      band.add((disc.centre.x - extent.left) * across, (disc.centre.y - extent.bottom) * up,
               disc.radius * across, fills[single ? 0 : i]);
    }
    band.write(raster, paper);
  };
  const int workers =
      std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, std::min(8, height));
  std::vector<std::thread> others;
  for (int k = 1; k < workers; ++k)
    others.emplace_back(draw, height * k / workers, height * (k + 1) / workers);
  draw(0, height / workers);
  for (std::thread& other : others) other.join();
  return raster;
}

}  // namespace hfrac::viz
