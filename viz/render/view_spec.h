// SPDX-License-Identifier: BSD-3-Clause
// Which view is meant: one of the list in run/views.hpp, or an array of the snapshot's files by its name.
#pragma once

#include <optional>
#include <string>

#include "run/views.hpp"

namespace hfrac::viz {
using namespace hfrac::run;

struct ViewSpec {
  std::string drawing;  // "discs", "bonds" or "forces"; empty: a quantity
  std::string title;    // empty: made from the array's name, as the label
  std::string label;
  std::string note;
  std::string array;  // its name with the unit at its end
  std::string file;   // "discs", "flow", "cracks", "bonds"; empty: the first of them that has it
  Combination how = Combination::component;
  int component = 0;
  std::optional<ColourScale> scale;  // none: by the values' signs
  bool all_values = false;
  bool smoothed = false;
  bool by_width = false;  // cracks as wide as the value is large

  // "[1]" of a component that is not the first.
  std::string component_text() const;
  std::string full_name() const { return array + component_text(); }
};

// Throws Failure(HFRAC_ERR_ARGUMENT).
ViewSpec view_named(const std::string& name);

// A line per name with what it shows.
std::string view_names();

}  // namespace hfrac::viz
