// SPDX-License-Identifier: BSD-3-Clause
// The views, each described once: `hfrac render --view`, hfrac_viz_view_names and the page (which gets this list with the
// index of a run) show the same quantities under the same names, with the same colour scales.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace hfrac::run {

/** How one number per item comes of an array. */
enum class Combination : int32_t {
  component,  ///< the one that NamedView::component names
  length,     ///< of a vector x, y
  mean,       ///< of xx and yy of a tensor
  shear       ///< the largest shear, of a tensor xx, yy, xy
};

/** Colour scales of both palettes, light and dark. */
enum class ColourScale : int32_t {
  magnitude,  ///< a size, on discs
  two_ways,   ///< a number with a sign: as far to both sides of zero
  narrow,     ///< along cracks
  pressure,   ///< of the fluid
  states      ///< none: one of few states, each with a name and a colour
};

struct NamedView {
  std::string_view name;   ///< "stress-xx"
  std::string_view title;  ///< "Stress along x"
  std::string_view label;  ///< above the colour scale, where its unit follows: "stress xx"
  std::string_view note;   ///< below the label
  std::string_view
      mesh;  ///< "discs", "cracks", "flow" or "joints": what is coloured; empty: no quantity, a drawing of its own
  std::string_view array;  ///< of the snapshot's files, with its unit at the end
  Combination how = Combination::component;
  int32_t component = 0;
  ColourScale scale = ColourScale::magnitude;
  bool all_values = false;  ///< the scale shows all values, not the middle 98 %
  bool smoothed =
      false;  ///< in pictures: over neighbouring discs, since the stress of a single one says little
  std::array<std::string_view, 4> states = {};  ///< what values 0, 1, 2, 3 mean, on the scale `states`
};

std::span<const NamedView> all_views();
/** nullptr if there is none of that name. */
const NamedView* view_of(std::string_view name);

/** "magnitude", "two-ways", "narrow", "pressure", "states"; "component", "length", "mean", "shear". */
std::string_view name_of(ColourScale scale);
std::string_view name_of(Combination how);

}  // namespace hfrac::run
