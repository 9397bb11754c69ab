// SPDX-License-Identifier: BSD-3-Clause
// A page of charts: panels with shapes and text around them, drawn on a page as every picture is.
//
// Places are in units of 1/1600 of the page's width, x to the right, y DOWN from the top left corner; a page is
// `page_height` of them high.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "chart_panel.h"
#include "offscreen_window.h"
#include "page.h"

namespace hfrac::viz {

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
