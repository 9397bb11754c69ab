// SPDX-License-Identifier: BSD-3-Clause
// One VTK chart's axes, set up in the house style: no box, round ticks.
//
// Curves and grid are drawn as lines of the page: VTK scales the pen of a plot together with its axes when it
// writes SVG or PDF, which turns a curve into a blot, and cuts the grid off at a place that does not move with the chart
// when the page is drawn in bands.
#pragma once

#include <vtkChartXY.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "chart_page.h"

namespace hfrac::viz {

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

// `box`: of the plot itself, in drawn pixels, `top` counted up from the page's lower edge. `unit`: drawn
// pixels of a unit of the page.
vtkSmartPointer<vtkChartXY> make_chart(const Box& box, const PanelRanges& ranges, const PanelTicks& ticks,
                                       double unit);

// The points of a series as shares of the plot's width and height; what cannot be shown is left out, a
// stepped series gets its corners, and of very many points those are kept that can be told apart.
std::vector<Point> curve_of(const Panel& panel, const ChartSeries& series, const PanelRanges& ranges);

}  // namespace hfrac::viz
