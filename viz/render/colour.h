// SPDX-License-Identifier: BSD-3-Clause
// Colours: the palette of all pictures, and the two scales for quantities.
//
// Everything stays apart for the common kinds of colour blindness, because what must be told apart differs in
// lightness too: yellow discs, blue bonds, black tensile cracks, magenta shear cracks, red wells. Both scales
// are even in lightness from end to end.
#pragma once

#include <cstdint>
#include <span>

namespace hfrac::viz {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};

namespace palette {
inline constexpr Colour paper{255, 255, 255};
inline constexpr Colour ink{28, 28, 32};
inline constexpr Colour faint_ink{110, 112, 120};
inline constexpr Colour frame{150, 152, 160};
inline constexpr Colour disc{255, 221, 87};
inline constexpr Colour disc_rim{222, 172, 30};
inline constexpr Colour soft_disc_rim{245, 204, 62};  // under a network of bonds
inline constexpr Colour quiet_disc{232, 233, 236};
inline constexpr Colour quiet_disc_rim{196, 198, 204};
inline constexpr Colour bond{24, 84, 214};
inline constexpr Colour tension{12, 12, 16};
inline constexpr Colour shear{200, 20, 140};
inline constexpr Colour well{214, 32, 38};
}  // namespace palette

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
// Amber over red to near black: narrow to wide, on light grey discs.
extern const ColourMap aperture_map;

}  // namespace hfrac::viz
