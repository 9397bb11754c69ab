// SPDX-License-Identifier: BSD-3-Clause
// What each kind of view shows: the layers that go into it and the key that explains them.
#pragma once

#include <string>
#include <vector>

#include "annotations.h"
#include "pictures.h"
#include "view_spec.h"

namespace hfrac::viz {

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
