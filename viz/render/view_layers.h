// SPDX-License-Identifier: BSD-3-Clause
// What each kind of view shows: the layers that go into it and the key that explains them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "annotations.h"
#include "pictures.h"
#include "run/views.hpp"

namespace hfrac::viz {

// Which view is meant: one of the list in run/views.hpp, or an array of the snapshot's files by its name.

using namespace hfrac::run;

struct ViewSpec {
  std::string drawing;  // "discs", "bonds" or "forces"; empty: a quantity
  std::string title;    // empty: made from the array's name, as the label
  std::string label;
  std::string note;
  std::string array;  // its name with the unit at its end
  std::string file;   // "discs", "flow", "cracks", "bonds", "joints"; empty: the first of them that has it
  Combination how = Combination::component;
  int component = 0;
  std::optional<ColourScale> scale;  // none: by the values' signs
  bool all_values = false;
  bool smoothed = false;
  bool by_width = false;                        // cracks as wide as the value is large
  std::array<std::string_view, 4> states = {};  // what values 0, 1, 2, 3 mean, on the scale `states`

  // "[1]" of a component that is not the first.
  std::string component_text() const;
  std::string full_name() const { return array + component_text(); }
};

// Throws Failure(HFRAC_ERR_ARGUMENT).
ViewSpec view_named(const std::string& name);

// A line per name with what it shows.
std::string view_names();

// The key of a view: a colour scale, or signs with names, or both.
struct Key {
  std::string title;  // what the view shows
  const ColourMap* map = nullptr;
  double lowest = 0;
  double highest = 1;
  std::string label;  // above the colour scale
  std::string second_label;
  std::vector<LegendEntry> entries;
};

// `unit_metres`: one design pixel in the view; `drawn_pixel`: one drawn pixel [m].
struct ViewSize {
  double unit_metres = 0;
  double drawn_pixel = 0;
};

// Adds the layers of a view. The scene has discs and cracks, what else is needed is read here. Throws Failure if the
// run has no such data.
Key add_view_layers(const View& view, const RunFolder& run, const Scene& scene, const ViewSpec& spec,
                    const ViewSize& size);

}  // namespace hfrac::viz
