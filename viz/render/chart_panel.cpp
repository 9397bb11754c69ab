// SPDX-License-Identifier: BSD-3-Clause
#include "chart_panel.h"

#include <algorithm>
#include <cmath>

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

}  // namespace hfrac::viz
