// SPDX-License-Identifier: BSD-3-Clause
// The seismic catalogue on one page: where events were, how strong, when, and how their strengths are spread.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "charts.h"
#include "frequency.h"

namespace hfrac::viz {
namespace {

struct LoggedEvent {
  Point place;           // [m]
  double time = 0;       // [s]
  double magnitude = 0;  // of the moment
  double moment = 0;     // [N m]
  double isotropic = 0;  // -1 to 1
};

std::vector<LoggedEvent> logged_events(const TableFile& table) {
  const auto x = table.numbers("x_m");
  const auto y = table.numbers("y_m");
  const auto time = table.numbers("time_s");
  const auto magnitude = table.numbers("magnitude");
  const auto moment = table.numbers("moment_N_m");
  const auto isotropic = table.numbers("isotropic_share");
  std::vector<LoggedEvent> events;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (!std::isfinite(x[i] + y[i] + time[i] + magnitude[i] + moment[i] + isotropic[i])) continue;
    events.push_back({{x[i], y[i]}, time[i], magnitude[i], moment[i], isotropic[i]});
  }
  return events;
}

// Feignier and Young (1992): above 0.3 volume was gained, below -0.3 lost, between them the rock sheared.
constexpr std::array<const char*, 3> kinds = {"opening", "shearing", "closing"};

std::size_t kind_of(const LoggedEvent& event) {
  if (event.isotropic > 0.3) return 0;
  return event.isotropic < -0.3 ? 2 : 1;
}

Colour colour_of(std::size_t kind) {
  return std::array<Colour, 3>{palette().water, palette().shear, palette().push}[kind];
}

// The square around all events and wells, a little larger.
Extent extent_of(const std::vector<LoggedEvent>& events, const RunFolder& run) {
  double left = INFINITY;
  double right = -INFINITY;
  double bottom = INFINITY;
  double top = -INFINITY;
  const auto include = [&](double x, double y, double radius) {
    left = std::min(left, x - radius);
    right = std::max(right, x + radius);
    bottom = std::min(bottom, y - radius);
    top = std::max(top, y + radius);
  };
  for (const LoggedEvent& event : events) include(event.place.x, event.place.y, 0);
  for (const WellPlace& well : run.wells) include(well.x, well.y, well.radius);
  if (!(right >= left)) return {0, 0, 1, 1};
  const double side = std::max({1.16 * (right - left), 1.16 * (top - bottom), 1e-6});
  return {(left + right - side) / 2, (bottom + top - side) / 2, side, side};
}

void put_axes(ChartPage& page, const Box& box, const Extent& extent) {
  const TextStyle style{20, palette().ink, false, Align::centre};
  for (const Tick& tick : round_ticks(extent.left, extent.left + extent.width, 5)) {
    const double x = box.left + box.width * (tick.value - extent.left) / extent.width;
    page.line({{x, box.top}, {x, box.bottom()}}, 1.2, palette().grid);
    page.text(x, box.bottom() + 30, tick.text, style);
  }
  for (const Tick& tick : round_ticks(extent.bottom, extent.bottom + extent.height, 5)) {
    const double y = box.bottom() - box.height * (tick.value - extent.bottom) / extent.height;
    page.line({{box.left, y}, {box.right(), y}}, 1.2, palette().grid);
    page.text(box.left - 10, y + 7, tick.text, {20, palette().ink, false, Align::right});
  }
  page.text(box.left + box.width / 2, box.bottom() + 66, "x (m)", {22, palette().ink, false, Align::centre});
  page.text(box.left - 62, box.top + box.height / 2, "y (m)",
            {22, palette().ink, false, Align::centre, true});
  page.line({{box.left, box.top}, {box.left, box.bottom()}, {box.right(), box.bottom()}}, 1.6,
            palette().frame);
}

// Areas as moments; the smallest can still be seen.
void put_map(ChartPage& page, const Box& box, const std::vector<LoggedEvent>& events, const RunFolder& run) {
  constexpr double largest_radius = 34;
  constexpr double smallest_radius = 2.5;
  const Extent extent = extent_of(events, run);
  put_axes(page, box, extent);
  const double scale = box.width / extent.width;
  const auto on_page = [&](Point place) {
    return Point{box.left + (place.x - extent.left) * scale,
                 box.bottom() - (place.y - extent.bottom) * scale};
  };
  for (const WellPlace& well : run.wells) {
    put_ring(page, on_page({well.x, well.y}), std::max(4.0, well.radius * scale), 3.0, palette().well);
  }
  std::vector<std::size_t> order(events.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return events[a].moment > events[b].moment; });
  const double strongest = events.empty() ? 1 : events[order.front()].moment;
  for (const std::size_t i : order) {
    const double radius = std::max(smallest_radius, largest_radius * std::sqrt(events[i].moment / strongest));
    page.dot(on_page(events[i].place), radius + 1.2, palette().paper);
    page.dot(on_page(events[i].place), radius, colour_of(kind_of(events[i])));
  }
}

Panel course_of(const std::vector<LoggedEvent>& events) {
  Panel panel{"Magnitude against time", "time (s)", {}, false, false};
  panel.free_zero = true;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    ChartSeries series{"", "", colour_of(kind), {}, {}};
    series.dots = true;
    for (const LoggedEvent& event : events) {
      if (kind_of(event) != kind) continue;
      series.x.push_back(event.time);
      series.y.push_back(event.magnitude);
    }
    if (!series.x.empty()) panel.series.push_back(std::move(series));
  }
  return panel;
}

}  // namespace

void fill_catalogue(ChartPage& page, const ChartData& data) {
  const std::vector<LoggedEvent> events = logged_events(data.events);
  put_heading(page, *data.run,
              "Seismic catalogue: " + counted(static_cast<std::int64_t>(events.size()), "event"));
  page.text(96, 128,
            "Cracks that broke together (Hazzard and Young 2000). Moment: force drop of their bonds times "
            "lever arm.",
            {18, palette().faint_ink});
  page.text(130, 205, "Where; areas as moments", {26, palette().ink, true});
  double left = 130;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const bool there = std::any_of(events.begin(), events.end(),
                                   [&](const LoggedEvent& event) { return kind_of(event) == kind; });
    if (!there) continue;
    page.dot({left + 8, 235}, 8, colour_of(kind));
    page.text(left + 26, 242, kinds[kind], {20, palette().ink});
    left += 60 + page.text_width(kinds[kind], {20, palette().ink});
  }
  put_map(page, {130, 270, 690, 690}, events, *data.run);
  page.panel({970, 270, 550, 250}, course_of(events));
  std::vector<double> magnitudes;
  for (const LoggedEvent& event : events) magnitudes.push_back(event.magnitude);
  page.panel({970, 710, 550, 250}, frequency_panel("Events at least as strong", std::move(magnitudes)));
}

}  // namespace hfrac::viz
