// SPDX-License-Identifier: BSD-3-Clause
// A page of charts: panels of VTK charts with shapes and text around them, as pixels or as SVG or PDF.
//
// Everything on it is in one 2-D scene, because that is what VTK's vector exporters understand. Places are in
// units of 1/1600 of the page's width, x to the right, y DOWN from the top left corner; a page is
// `page_height` of them high.
#pragma once

#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextTransform.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image.h"
#include "number_text.h"
#include "offscreen_window.h"
#include "page.h"

namespace hfrac::viz {

class ShapeItem;
struct PanelRanges;
struct PanelTicks;

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

class ChartPage {
 public:
  // `pixels`: drawn pixels per unit.
  ChartPage(OffscreenWindow* window, double page_height, double pixels);
  ~ChartPage();
  ChartPage(const ChartPage&) = delete;
  ChartPage& operator=(const ChartPage&) = delete;

  static constexpr double width = 1600;
  double height() const { return height_; }

  // `box` is the plot itself; title and names stand above it, ticks and labels around it.
  void panel(const Box& box, const Panel& panel);
  void line(const std::vector<Point>& points, double thickness, Colour colour);
  void dot(Point centre, double radius, Colour colour);
  void polygon(const std::vector<Point>& corners, Colour fill);
  void text(double x, double y, const std::string& content, const TextStyle& style);
  double text_width(const std::string& content, const TextStyle& style) const;

  // The page's pixels, each the mean of `factor` x `factor` drawn ones.
  Image draw(int factor);
  void write_svg(const std::filesystem::path& path, const std::string& title);
  void write_pdf(const std::filesystem::path& path, const std::string& title);

 private:
  void put_spread(const Box& box, const Panel& panel, const ChartSeries& series, const PanelRanges& ranges);
  void put_grid(const Box& box, const PanelRanges& ranges, const PanelTicks& ticks);
  void put_curves(const Box& box, const Panel& panel, const PanelRanges& ranges);
  void put_names(const Box& box, const Panel& panel);
  void render();

  OffscreenWindow* window_;
  double height_;
  double pixels_;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkContextActor> actor_;
  vtkSmartPointer<vtkContextTransform> sheet_;  // holds the charts and, over them, the shapes
  vtkSmartPointer<ShapeItem> shapes_;

  std::vector<Point> placed(const std::vector<Point>& points) const;
};

}  // namespace hfrac::viz
