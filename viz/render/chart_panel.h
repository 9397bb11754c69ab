// SPDX-License-Identifier: BSD-3-Clause
// A panel of a page of charts in numbers: what its axes show, their round ticks, and where its curves run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "number_text.h"
#include "page.h"

namespace hfrac::viz {

// A line of a panel: points, and how they are joined.
struct ChartSeries {
  std::string name;
  std::string unit;
  Colour colour;
  std::vector<double> x;
  std::vector<double> y;
  bool right = false;    // belongs to the axis at the right
  bool stepped = false;  // stays until the next point
  bool dots = false;     // points only
  double dot_radius = 5.5;
  std::vector<double> spread = {};  // half lengths of error bars, NaN for none; empty: no bars
  bool banded = false;              // a band of that width instead of bars
};

struct Panel {
  std::string title;
  std::string x_label;
  std::vector<ChartSeries> series;   // at most one unit per axis
  bool logarithmic = false;          // the left axis
  bool whole_numbers = false;        // the left axis counts
  bool free_zero = false;            // the left axis need not show zero
  std::string unit = {};             // beside the title, if the series do not tell
  std::optional<Extent> shown = {};  // what the axes end at, as it stands; otherwise as the series ask
};

struct Range {
  double lowest = 0;
  double highest = 0;
  double share(double value) const { return (value - lowest) / (highest - lowest); }
};

// What the axes of a panel show; values on a logarithmic axis are their logarithms.
struct PanelRanges {
  Range x;
  Range left;
  Range right;
  bool has_right = false;
};
PanelRanges ranges_of(const Panel& panel);

// Values on the axes with their texts.
struct PanelTicks {
  std::vector<Tick> x;
  std::vector<Tick> left;
  std::vector<Tick> right;
};
// `width`, `height`: of the plot in units of the page.
PanelTicks ticks_of(const Panel& panel, const PanelRanges& ranges, double width, double height);

// The points of a series as shares of the plot's width and height; what cannot be shown is left out, a
// stepped series gets its corners, and of very many points those are kept that can be told apart.
std::vector<Point> curve_of(const Panel& panel, const ChartSeries& series, const PanelRanges& ranges);

}  // namespace hfrac::viz
