// SPDX-License-Identifier: BSD-3-Clause
// A PNG file back in memory, with the questions the tests ask of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace hfrac::viz_test {

struct Pixel {
  int red = 0;
  int green = 0;
  int blue = 0;

  bool is_red() const { return red > 180 && green < 90 && blue < 90; }
  bool is_dark() const { return red < 70 && green < 70 && blue < 70; }
  bool is_magenta() const { return red > 150 && green < 90 && blue > 90; }
  bool is_yellow() const { return red > 190 && green > 140 && red - blue > 70 && green - blue > 40; }
  bool is_white() const { return red > 245 && green > 245 && blue > 245; }
};

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  // from the top down

  Pixel at(int x, int y) const;
  // Share of the pixels inside a box for which `test` holds.
  template <class Test>
  double share(int left, int top, int right, int bottom, const Test& test) const {
    int count = 0;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) count += test(at(x, y)) ? 1 : 0;
    }
    return static_cast<double>(count) / ((right - left) * (bottom - top));
  }
};

Picture read_picture(const std::filesystem::path& path);

// The framed view of the model in a picture, found by its grey frame, and where in it the model's points are.
struct FramedView {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  double model_width = 0;   // [m]
  double model_height = 0;  // [m]

  int x(double metres) const;
  int y(double metres) const;
};

FramedView find_view(const Picture& picture, double model_width, double model_height);

}  // namespace hfrac::viz_test
