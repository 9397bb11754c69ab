// SPDX-License-Identifier: BSD-3-Clause
#include "command/paper.hpp"

#include <cmath>

namespace hfrac::command {
namespace {

constexpr double millimetres_per_inch = 25.4;
constexpr int32_t print_resolution = 300;  // [dots per inch]

}  // namespace

int32_t Paper::pixels() const {
  if (print > 0.0) return static_cast<int32_t>(std::lround(print / millimetres_per_inch * print_resolution));
  return width;
}

int32_t Paper::dots_per_inch() const {
  return print > 0.0 ? print_resolution : 0;
}

void add_paper_options(CLI::App& command, Paper& paper) {
  auto* width = command.add_option("--width", paper.width, "Width of the pictures in pixels")
                    ->check(CLI::Range(320, 8192));
  command.add_option("--print", paper.print, "Width on paper in millimetres, drawn at 300 dots per inch")
      ->check(CLI::Range(40.0, 690.0))
      ->excludes(width);
  command.add_flag("--dark", paper.dark, "Light on dark paper");
}

}  // namespace hfrac::command
