// SPDX-License-Identifier: BSD-3-Clause
// Which view is meant: one of enum hfrac_viz_view, or an array of the snapshot's files by its name.
#pragma once

#include <string>

namespace hfrac::viz {

constexpr int array_view = -1;

struct ViewSpec {
  int kind = 0;       // enum hfrac_viz_view, or array_view
  std::string array;  // its name with the unit at its end
  std::string file;   // "discs", "flow", "cracks", "bonds"; empty: the first of them that has it
  int component = 0;  // from 0
};

// Throws Failure(HFRAC_ERR_ARGUMENT).
ViewSpec view_named(const std::string& name);
ViewSpec view_of_kind(int kind);

// A line per name with what it shows.
std::string view_names();

}  // namespace hfrac::viz
