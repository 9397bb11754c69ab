// SPDX-License-Identifier: BSD-3-Clause
#include "colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hfrac::viz {
namespace {

// 0xrrggbb
constexpr Colour colour(std::uint32_t code) {
  return {static_cast<std::uint8_t>(code >> 16U), static_cast<std::uint8_t>(code >> 8U & 255U),
          static_cast<std::uint8_t>(code & 255U)};
}

template <std::size_t count>
constexpr std::array<Colour, count> colours(const std::uint32_t (&codes)[count]) {
  std::array<Colour, count> all{};
  for (std::size_t i = 0; i < count; ++i) all[i] = colour(codes[i]);
  return all;
}

constexpr auto blue_to_yellow =
    colours({0x362462, 0x3a4480, 0x32628c, 0x287e8e, 0x249888, 0x3eb474, 0x7aca54, 0xbedc3c, 0xfae83c});

// On light grey discs: narrow is amber, wide nearly black.
constexpr auto amber_to_black =
    colours({0xfab23c, 0xf2882c, 0xde5c34, 0xbc3654, 0x8c2268, 0x541264, 0x160a32});

// On dark discs the other way round: narrow is violet, wide nearly white.
constexpr auto violet_to_white =
    colours({0x7e3caa, 0xaa3ea0, 0xd24882, 0xee645c, 0xfa9246, 0xfdc460, 0xfff4be});

constexpr auto indigo_to_cream =
    colours({0x261a56, 0x54267e, 0x883284, 0xbc4274, 0xe66458, 0xfa9c5a, 0xfee296});

constexpr auto blue_grey_red =
    colours({0x104296, 0x427cc4, 0x96bade, 0xe8e8e8, 0xf0b08c, 0xd46444, 0x8e1424});

constexpr auto blue_dark_red =
    colours({0x96ceff, 0x5096e6, 0x2e5c96, 0x3a3c42, 0xa04634, 0xec744c, 0xffc696});

const ColourMap dark_on_light(amber_to_black);
const ColourMap light_on_dark(violet_to_white);
const ColourMap two_ways_light(blue_grey_red);
const ColourMap two_ways_dark(blue_dark_red);

const Palette light = {{255, 255, 255}, {28, 28, 32},   {110, 112, 120}, {150, 152, 160}, {228, 229, 233},
                       {255, 221, 87},  {222, 172, 30}, {245, 204, 62},  {232, 233, 236}, {196, 198, 204},
                       {24, 84, 214},   {12, 12, 16},   {200, 20, 140},  {214, 32, 38},   {20, 110, 180},
                       {206, 74, 32},   {28, 92, 170},  &dark_on_light,  &two_ways_light};

const Palette dark = {{20, 22, 27},   {236, 237, 240}, {158, 162, 172}, {104, 108, 118}, {46, 49, 57},
                      {84, 88, 100},  {120, 125, 140}, {100, 105, 118}, {50, 53, 61},    {72, 76, 86},
                      {92, 156, 255}, {255, 255, 250}, {255, 92, 200},  {255, 96, 84},   {88, 178, 255},
                      {255, 150, 88}, {96, 170, 255},  &light_on_dark,  &two_ways_dark};

const Palette* in_force = &light;

constexpr std::array<Colour, 6> deep_blue_to_amber = {
    {{40, 44, 130}, {34, 96, 160}, {30, 140, 140}, {96, 160, 70}, {200, 140, 30}, {206, 74, 32}}};
constexpr std::array<Colour, 6> sky_to_amber = {
    {{120, 140, 255}, {80, 176, 240}, {70, 210, 190}, {150, 220, 110}, {240, 200, 90}, {255, 140, 90}}};
const ColourMap series_light(deep_blue_to_amber);
const ColourMap series_dark(sky_to_amber);

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double share) {
  return static_cast<std::uint8_t>(std::lround(from + (to - from) * share));
}

}  // namespace

const ColourMap pressure_map(blue_to_yellow);
const ColourMap magnitude_map(indigo_to_cream);

const Palette& light_palette() {
  return light;
}

const Palette& dark_palette() {
  return dark;
}

const Palette& palette() {
  return *in_force;
}

std::string hexadecimal(Colour colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

Colour mixed(Colour from, Colour to, double share) {
  return {mixed(from.red, to.red, share), mixed(from.green, to.green, share),
          mixed(from.blue, to.blue, share)};
}

const ColourMap& series_map() {
  return in_force == &dark ? series_dark : series_light;
}

Colour categorical(std::size_t index) {
  static constexpr std::array<Colour, 6> on_light = {
      {{0, 114, 178}, {213, 94, 0}, {0, 138, 100}, {180, 90, 150}, {170, 120, 0}, {60, 60, 66}}};
  static constexpr std::array<Colour, 6> on_dark = {
      {{86, 180, 233}, {240, 130, 60}, {40, 200, 150}, {220, 140, 190}, {240, 228, 66}, {220, 220, 224}}};
  return (in_force == &dark ? on_dark : on_light)[index % on_light.size()];
}

PaletteScope::PaletteScope(const Palette& chosen) : previous_(in_force) {
  in_force = &chosen;
}

PaletteScope::~PaletteScope() {
  in_force = previous_;
}

Colour ColourMap::at(double share) const {
  const double clamped = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
  const double position = clamped * static_cast<double>(points_.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(position), points_.size() - 2);
  const double rest = position - static_cast<double>(below);
  const Colour& from = points_[below];
  const Colour& to = points_[below + 1];
  return mixed(from, to, rest);
}

}  // namespace hfrac::viz
