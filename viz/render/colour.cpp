// SPDX-License-Identifier: BSD-3-Clause
#include "colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hfrac::viz {
namespace {

constexpr std::array<Colour, 9> blue_to_yellow = {{{54, 36, 98},
                                                   {58, 68, 128},
                                                   {50, 98, 140},
                                                   {40, 126, 142},
                                                   {36, 152, 136},
                                                   {62, 180, 116},
                                                   {122, 202, 84},
                                                   {190, 220, 60},
                                                   {250, 232, 60}}};

constexpr std::array<Colour, 7> amber_to_black = {{{250, 178, 60},
                                                   {242, 136, 44},
                                                   {222, 92, 52},
                                                   {188, 54, 84},
                                                   {140, 34, 104},
                                                   {84, 18, 100},
                                                   {22, 10, 50}}};

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double share) {
  return static_cast<std::uint8_t>(std::lround(from + (to - from) * share));
}

}  // namespace

const ColourMap pressure_map(blue_to_yellow);
const ColourMap aperture_map(amber_to_black);

Colour ColourMap::at(double share) const {
  const double clamped = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
  const double position = clamped * static_cast<double>(points_.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(position), points_.size() - 2);
  const double rest = position - static_cast<double>(below);
  const Colour& from = points_[below];
  const Colour& to = points_[below + 1];
  return {mixed(from.red, to.red, rest), mixed(from.green, to.green, rest), mixed(from.blue, to.blue, rest)};
}

}  // namespace hfrac::viz
