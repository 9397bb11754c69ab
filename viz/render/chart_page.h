// SPDX-License-Identifier: BSD-3-Clause
// A page of charts: panels with shapes and text around them, drawn on a page as every picture is.
//
// Places are in units of 1/1600 of the page's width, x to the right, y DOWN from the top left corner; a page is
// `page_height` of them high.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "number_text.h"
#include "offscreen_window.h"
#include "page.h"

namespace hfrac::viz {

// A panel of a page of charts in numbers: what its axes show, their round ticks, and where its curves run.

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

class ChartPage {
 public:
  // `pixels`: width of the finished page.
  ChartPage(OffscreenWindow* window, double page_height, int pixels);

  static constexpr double width = 1600;
  Page& page() { return page_; }

  // `box` is the plot itself; title and names stand above it, ticks and labels around it.
  void panel(const Box& box, const Panel& panel);
  void line(const std::vector<Point>& points, double thickness, Colour colour);
  void dot(Point centre, double radius, Colour colour);
  void polygon(const std::vector<Point>& corners, Colour fill);
  // x: the start (middle, end) of the text; y: the lower edge of its letters, g and p included.
  void text(double x, double y, const std::string& content, TextStyle style);
  double text_width(const std::string& content, TextStyle style) const;

 private:
  void put_spread(const Box& box, const Panel& panel, const ChartSeries& series, const PanelRanges& ranges);
  void put_axes(const Box& box, const PanelRanges& ranges, const PanelTicks& ticks);
  void put_curves(const Box& box, const Panel& panel, const PanelRanges& ranges);
  void put_names(const Box& box, const Panel& panel);

  double scale_;  // pixels of a unit
  Page page_;
};

struct PageContent {
  std::string title;  // of the document
  double height = 0;  // of the page, in its units
  std::function<void(ChartPage&)> fill;
};

struct PagePixels {
  int width = 1600;
  int dots_per_inch = 0;  // noted in the file, 0: not
};

// Into a PNG file of that many pixels, or an SVG or PDF file. Throws Failure(HFRAC_ERR_ARGUMENT) for any other ending.
void write_page(const std::filesystem::path& target, const PageContent& content, OffscreenWindow* window,
                const PagePixels& pixels);

}  // namespace hfrac::viz
