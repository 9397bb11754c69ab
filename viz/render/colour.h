// SPDX-License-Identifier: BSD-3-Clause
// Colours: the palettes of all pictures, one for white and one for dark paper, and the scales for quantities.
//
// Everything stays apart for the common kinds of colour blindness, because what must be told apart differs in
// lightness too: yellow discs, blue bonds, black (on dark paper white) tensile cracks, magenta shear cracks,
// red wells. All scales are even in lightness from end to end, those of two ways from the middle outwards.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace hfrac::viz {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};

class ColourMap;

// "#rrggbb"
std::string hexadecimal(Colour colour);
// From `from` (share 0) to `to` (share 1).
Colour mixed(Colour from, Colour to, double share);

// What everything is drawn in. `paper` is the ground, `ink` writes on it.
struct Palette {
  Colour paper;
  Colour ink;
  Colour faint_ink;
  Colour frame;
  Colour grid;  // of charts
  Colour disc;
  Colour disc_rim;
  Colour soft_disc_rim;  // under a network of bonds
  Colour quiet_disc;
  Colour quiet_disc_rim;
  Colour bond;
  Colour tension;
  Colour shear;
  Colour well;
  Colour water;               // curves of fluid
  Colour pull;                // bonds in tension
  Colour push;                // bonds in compression
  const ColourMap* narrow;    // apertures: stands out from the quiet discs at both ends
  const ColourMap* two_ways;  // quantities with a sign, the paper's grey in the middle
};

const Palette& light_palette();
const Palette& dark_palette();
// The one in force. Drawing goes one call after another, so there is one for the process.
const Palette& palette();

// Draws in `chosen` while it lives.
class PaletteScope {
 public:
  explicit PaletteScope(const Palette& chosen);
  ~PaletteScope();
  PaletteScope(const PaletteScope&) = delete;
  PaletteScope& operator=(const PaletteScope&) = delete;

 private:
  const Palette* previous_;
};

// A colour scale: control points at equal distances, straight lines between them.
class ColourMap {
 public:
  explicit constexpr ColourMap(std::span<const Colour> points) : points_(points) {}
  // share in [0, 1]; outside: the nearest end.
  Colour at(double share) const;

 private:
  std::span<const Colour> points_;
};

// Dark blue over green to yellow: low to high pressure. Black cracks stand out where the pressure is.
extern const ColourMap pressure_map;
// Lightness rises from end to end; for quantities without a sign.
extern const ColourMap magnitude_map;

// Curves of one family, in order of a number; both ends stand out from the paper in force.
const ColourMap& series_map();
// Curves without an order, from 0; a dozen, then over again. Okabe and Ito (2008): apart for the common kinds of
// colour blindness.
Colour categorical(std::size_t index);

}  // namespace hfrac::viz
