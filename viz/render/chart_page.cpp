// SPDX-License-Identifier: BSD-3-Clause
#include "chart_page.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "page.h"
#include "run/files.hpp"
#include "vtk_messages.h"

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

ChartPage::ChartPage(OffscreenWindow* window, double page_height, int pixels)
    : scale_(pixels / width),
      page_(window, pixels, static_cast<int>(std::lround(page_height * scale_)), pixels <= 2700 ? 3 : 2) {}

void ChartPage::line(const std::vector<Point>& points, double thickness, Colour colour) {
  for (std::size_t i = 1; i < points.size(); ++i)
    page_.line(points[i - 1].x * scale_, points[i - 1].y * scale_, points[i].x * scale_, points[i].y * scale_,
               thickness * scale_, colour);
}

void ChartPage::polygon(const std::vector<Point>& corners, Colour fill) {
  std::vector<Point> placed;
  placed.reserve(corners.size());
  for (const Point& corner : corners) placed.push_back({corner.x * scale_, corner.y * scale_});
  page_.polygon(placed, fill);
}

void ChartPage::dot(Point centre, double radius, Colour colour) {
  constexpr int corner_count = 24;
  std::vector<Point> corners;
  for (int i = 0; i < corner_count; ++i) {
    const double angle = 2 * std::numbers::pi * i / corner_count;
    corners.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  polygon(corners, colour);
}

void ChartPage::text(double x, double y, const std::string& content, TextStyle style) {
  constexpr double descent = 0.236;  // of the em, below the baseline: `y` is the lower edge of the letters
  style.size *= scale_;
  page_.text(x * scale_, y * scale_ - descent * style.size, content, style);
}

double ChartPage::text_width(const std::string& content, TextStyle style) const {
  style.size *= scale_;
  return page_.text_width(content, style) / scale_;
}

void ChartPage::panel(const Box& box, const Panel& panel) {
  const PanelRanges ranges = ranges_of(panel);
  put_axes(box, ranges, ticks_of(panel, ranges, box.width, box.height));
  put_curves(box, panel, ranges);
  put_names(box, panel);
}

// Lines at the left, below and, if it has one, at the right, with ticks outwards; faint ones across at the ticks, but where
// an axis is.
void ChartPage::put_axes(const Box& box, const PanelRanges& ranges, const PanelTicks& ticks) {
  constexpr double thickness = 1.6, faint = 1.2, length = 6, gap = 9, rise = 9.5;
  const auto apart = [](double share) { return share > 1e-3 && share < 1 + 1e-9; };
  TextStyle style{18, palette().ink, false, Align::centre};
  for (const Tick& tick : ticks.x) {
    const double x = box.left + box.width * ranges.x.share(tick.value);
    if (apart(ranges.x.share(tick.value))) line({{x, box.bottom() - 1}, {x, box.top}}, faint, palette().grid);
    line({{x, box.bottom()}, {x, box.bottom() + length}}, thickness, palette().frame);
    text(x, box.bottom() + 27, tick.text, style);
  }
  const auto upright = [&](double side, double out, const Range& range, const std::vector<Tick>& marks) {
    for (const Tick& tick : marks) {
      const double y = box.bottom() - box.height * range.share(tick.value);
      line({{side, y}, {side + out * length, y}}, thickness, palette().frame);
      text(side + out * gap, y + rise, tick.text, style);
    }
    line({{side, box.bottom()}, {side, box.top}}, thickness, palette().frame);
  };
  for (const Tick& tick : ticks.left) {
    const double y = box.bottom() - box.height * ranges.left.share(tick.value);
    if (apart(ranges.left.share(tick.value)))
      line({{box.left + 1, y}, {box.right(), y}}, faint, palette().grid);
  }
  style.align = Align::right;
  upright(box.left, -1, ranges.left, ticks.left);
  style.align = Align::left;
  if (ranges.has_right) upright(box.right(), 1, ranges.right, ticks.right);
  line({{box.left, box.bottom()}, {box.right(), box.bottom()}}, thickness, palette().frame);
}

// Error bars, or the band they would make, below the curve itself.
void ChartPage::put_spread(const Box& box, const Panel& panel, const ChartSeries& series,
                           const PanelRanges& ranges) {
  ChartSeries low = series;
  ChartSeries high = series;
  for (std::size_t i = 0; i < series.spread.size() && i < series.y.size(); ++i) {
    const double half = std::isfinite(series.spread[i]) ? series.spread[i] : 0.0;
    low.y[i] -= half;
    high.y[i] += half;
  }
  low.dots = high.dots = true;  // every point, none left out
  const auto on_page = [&](const ChartSeries& edge) {
    std::vector<Point> points = curve_of(panel, edge, ranges);
    for (Point& point : points) point = {box.left + box.width * point.x, box.bottom() - box.height * point.y};
    return points;
  };
  const std::vector<Point> lower = on_page(low);
  const std::vector<Point> upper = on_page(high);
  if (lower.size() != upper.size()) return;
  if (series.banded) {
    // Slices between neighbours: a band may cross itself nowhere, but need not be convex.
    const Colour fill = mixed(series.colour, palette().paper, 0.82);
    for (std::size_t i = 1; i < lower.size(); ++i)
      polygon({lower[i - 1], lower[i], upper[i], upper[i - 1]}, fill);
    return;
  }
  for (std::size_t i = 0; i < lower.size(); ++i) {
    if (!(lower[i].y > upper[i].y)) continue;
    line({lower[i], upper[i]}, 2, series.colour);
    for (const Point& end : {lower[i], upper[i]})
      line({{end.x - 7, end.y}, {end.x + 7, end.y}}, 2, series.colour);
  }
}

void ChartPage::put_curves(const Box& box, const Panel& panel, const PanelRanges& ranges) {
  for (const ChartSeries& series : panel.series) {
    if (!series.spread.empty()) put_spread(box, panel, series, ranges);
  }
  for (const ChartSeries& series : panel.series) {
    std::vector<Point> points = curve_of(panel, series, ranges);
    for (Point& point : points) {
      point = {box.left + box.width * point.x, box.bottom() - box.height * point.y};
      if (series.dots) dot(point, series.dot_radius, series.colour);
    }
    if (!series.dots) line(points, 2.8, series.colour);
  }
}

// The names of the series take the place of a legend: each in its colour, above the plot, where nothing lies
// below them. The unit stands there too: with the title, or with each name if there are two axes.
void ChartPage::put_names(const Box& box, const Panel& panel) {
  const bool two_axes = std::any_of(panel.series.begin(), panel.series.end(),
                                    [](const ChartSeries& series) { return series.right; });
  const bool named = std::any_of(panel.series.begin(), panel.series.end(),
                                 [](const ChartSeries& series) { return !series.name.empty(); });
  const TextStyle title{23, palette().ink, true};
  const double title_y = box.top - (named ? 50 : 20);
  text(box.left, title_y, panel.title, title);
  std::string unit = panel.unit;
  if (unit.empty() && !two_axes && !panel.series.empty()) unit = panel.series.front().unit;
  text(box.left + text_width(panel.title, title) + 12, title_y, unit, {20, palette().faint_ink});
  text(box.left + box.width / 2, box.bottom() + 62, panel.x_label, {20, palette().ink, false, Align::centre});
  double x = box.left;
  for (const ChartSeries& series : panel.series) {
    if (series.name.empty()) continue;
    const TextStyle style{18, palette().ink};
    const double y = box.top - 18;
    polygon({{x, y - 12}, {x + 22, y - 12}, {x + 22, y - 7}, {x, y - 7}}, series.colour);
    const std::string name =
        two_axes ? series.name + (series.right ? " (right, " : " (left, ") + series.unit + ")" : series.name;
    text(x + 30, y, name, style);
    x += 30 + text_width(name, style) + 28;
  }
}

void write_page(const std::filesystem::path& target, const PageContent& content, OffscreenWindow* window,
                const PagePixels& pixels) {
  const std::string ending = picture_ending(target);
  const bool png = ending == ".png";
  VtkMessages messages;
  ChartPage page(window, content.height, png ? pixels.width : static_cast<int>(ChartPage::width));
  content.fill(page);
  constexpr int points_per_inch = 72;  // a unit of a PDF page is a point
  const auto bytes =
      page_content(page.page(), ending, content.title, png ? pixels.dots_per_inch : points_per_inch);
  messages.demand_none();
  write_whole(target, bytes);
}

}  // namespace hfrac::viz
