// SPDX-License-Identifier: BSD-3-Clause
#include "chart_panel.h"

#include <vtkAxis.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "fonts.h"

namespace hfrac::viz {
namespace {

// The span of values that have been seen.
struct Span {
  double lowest = INFINITY;
  double highest = -INFINITY;
  void include(double value) {
    if (!std::isfinite(value)) return;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  bool empty() const { return !(highest >= lowest); }
};

// What a value is drawn as; NaN is left out.
double drawn_value(double value, bool logarithmic) {
  if (!logarithmic) return value;
  return value > 0 ? std::log10(value) : std::nan("");
}

void paint(vtkPen* pen, Colour colour, double thickness) {
  pen->SetLineType(vtkPen::SOLID_LINE);
  pen->SetColor(colour.red, colour.green, colour.blue, 255);
  pen->SetWidth(static_cast<float>(thickness));
}

std::vector<Tick> ticks_of(const Range& range, double room, bool logarithmic, bool whole_numbers) {
  const int wanted = std::max(2, static_cast<int>(room));
  std::vector<Tick> ticks = round_ticks(range.lowest, range.highest, wanted);
  if (logarithmic) {
    std::erase_if(ticks, [](const Tick& tick) { return tick.value != std::round(tick.value); });
    for (Tick& tick : ticks) tick.text = value_text(std::pow(10.0, tick.value));
  } else if (whole_numbers) {
    std::erase_if(ticks,
                  [](const Tick& tick) { return std::fabs(tick.value - std::round(tick.value)) > 1e-9; });
    for (Tick& tick : ticks) tick.text = count_text(std::llround(tick.value));
  } else if (std::max(std::fabs(range.lowest), std::fabs(range.highest)) < 5e-3 || range.highest >= 1e5) {
    for (Tick& tick : ticks) tick.text = value_text(tick.value);
  }
  return ticks;
}

void set_axis(vtkAxis* axis, const Range& range, const std::vector<Tick>& ticks, double unit) {
  axis->SetVisible(true);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(range.lowest, range.highest);
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> texts;
  for (const Tick& tick : ticks) {
    places->InsertNextValue(tick.value);
    texts->InsertNextValue(tick.text);
  }
  axis->SetCustomTickPositions(places, texts);
  axis->SetTitle("");  // VTK would put it over wide tick labels; the page writes it
  set_font(axis->GetLabelProperties(), false, 18 * unit, palette().ink);
  axis->SetLabelOffset(static_cast<float>(9 * unit));
  axis->SetTickLength(static_cast<float>(6 * unit));
  axis->SetMargins(static_cast<int>(12 * unit), static_cast<int>(10 * unit));
  paint(axis->GetPen(), palette().frame, 1.6 * unit);
  axis->SetGridVisible(false);
}

void hide_axis(vtkAxis* axis) {
  axis->SetVisible(false);
  axis->SetGridVisible(false);
}

Range with_room(Span span, double room, bool from_zero) {
  if (span.empty()) span = {0, 1};
  if (from_zero) span.include(0);
  if (!(span.highest > span.lowest)) span.highest += span.highest != 0 ? std::fabs(span.highest) : 1.0;
  const double size = span.highest - span.lowest;
  return {span.lowest != 0 ? span.lowest - room * size : 0.0,
          span.highest != 0 ? span.highest + room * size : 0.0};
}

// Where many points share a column of pixels, its first, lowest, highest and last one.
std::vector<Point> thinned(const std::vector<Point>& points) {
  constexpr std::size_t columns = 1000;
  if (points.size() <= 6 * columns) return points;
  std::vector<Point> kept;
  for (std::size_t column = 0; column < columns; ++column) {
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(points.size() * column / columns);
    const auto end = points.begin() + static_cast<std::ptrdiff_t>(points.size() * (column + 1) / columns);
    const auto [low, high] =
        std::minmax_element(first, end, [](const Point& a, const Point& b) { return a.y < b.y; });
    for (const auto& point : {first, std::min(low, high), std::max(low, high), end - 1})
      kept.push_back(*point);
  }
  return kept;
}

// VTK draws the axes of a chart only if it has a plot: this one has two corners and no marks.
void add_unseen_plot(vtkChartXY* chart, const Range& x, const Range& y, int corner) {
  vtkNew<vtkDoubleArray> places_x;
  vtkNew<vtkDoubleArray> places_y;
  places_x->SetName("x");
  places_y->SetName("y");
  for (const double value : {x.lowest, x.highest}) places_x->InsertNextValue(value);
  for (const double value : {y.lowest, y.highest}) places_y->InsertNextValue(value);
  vtkNew<vtkTable> table;
  table->AddColumn(places_x);
  table->AddColumn(places_y);
  vtkNew<vtkPlotPoints> plot;
  plot->SetInputData(table, 0, 1);
  plot->SetMarkerStyle(vtkPlotPoints::NONE);
  chart->AddPlot(plot);
  chart->SetPlotCorner(plot, corner);
}

}  // namespace

PanelRanges ranges_of(const Panel& panel) {
  if (panel.shown) {
    const Extent& shown = *panel.shown;
    return {{shown.left, shown.left + shown.width}, {shown.bottom, shown.bottom + shown.height}, {}, false};
  }
  Span x;
  Span left;
  Span right;
  for (const ChartSeries& series : panel.series) {
    for (const double value : series.x) x.include(value);
    Span& span = series.right ? right : left;
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      const bool logarithmic = panel.logarithmic && !series.right;
      const double spread =
          i < series.spread.size() && std::isfinite(series.spread[i]) ? series.spread[i] : 0.0;
      span.include(drawn_value(series.y[i], logarithmic));
      span.include(drawn_value(series.y[i] - spread, logarithmic));
      span.include(drawn_value(series.y[i] + spread, logarithmic));
    }
  }
  if (panel.logarithmic && !left.empty()) left = {std::floor(left.lowest), std::ceil(left.highest + 1e-9)};
  return {with_room(x, 0.03, false),
          with_room(left, panel.logarithmic ? 0 : 0.06, !panel.logarithmic && !panel.free_zero),
          with_room(right, 0.06, true), !right.empty()};
}

PanelTicks ticks_of(const Panel& panel, const PanelRanges& ranges, double width, double height) {
  const double rows = height / 60;
  PanelTicks ticks{ticks_of(ranges.x, width / 130, false, false),
                   ticks_of(ranges.left, rows, panel.logarithmic, panel.whole_numbers),
                   {}};
  if (ranges.has_right) ticks.right = ticks_of(ranges.right, rows, false, false);
  return ticks;
}

std::vector<Point> curve_of(const Panel& panel, const ChartSeries& series, const PanelRanges& ranges) {
  const Range& range = series.right ? ranges.right : ranges.left;
  std::vector<Point> points;
  for (std::size_t i = 0; i < series.x.size() && i < series.y.size(); ++i) {
    const double value = drawn_value(series.y[i], panel.logarithmic && !series.right);
    if (!std::isfinite(series.x[i]) || !std::isfinite(value)) continue;
    const Point point{ranges.x.share(series.x[i]), range.share(value)};
    if (series.stepped && !points.empty() && points.back().y != point.y)
      points.push_back({point.x, points.back().y});
    points.push_back(point);
  }
  return series.dots ? points : thinned(points);
}

vtkSmartPointer<vtkChartXY> make_chart(const Box& box, const PanelRanges& ranges, const PanelTicks& ticks,
                                       double unit) {
  auto chart = vtkSmartPointer<vtkChartXY>::New();
  chart->SetAutoSize(false);
  chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  chart->SetSize(vtkRectf(static_cast<float>(box.left), static_cast<float>(box.top),
                          static_cast<float>(box.width), static_cast<float>(box.height)));
  chart->SetShowLegend(false);
  chart->SetRenderEmpty(true);
  set_axis(chart->GetAxis(vtkAxis::BOTTOM), ranges.x, ticks.x, unit);
  set_axis(chart->GetAxis(vtkAxis::LEFT), ranges.left, ticks.left, unit);
  add_unseen_plot(chart, ranges.x, ranges.left, 0);
  hide_axis(chart->GetAxis(vtkAxis::TOP));
  hide_axis(chart->GetAxis(vtkAxis::RIGHT));
  if (ranges.has_right) {
    add_unseen_plot(chart, ranges.x, ranges.right, 1);
    set_axis(chart->GetAxis(vtkAxis::RIGHT), ranges.right, ticks.right, unit);
  }
  return chart;
}

}  // namespace hfrac::viz
