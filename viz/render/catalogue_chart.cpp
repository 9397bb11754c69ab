// SPDX-License-Identifier: BSD-3-Clause
// The seismic catalogue on one page: where events were, how strong, when, and how their strengths are spread.
#include <hfrac/hfrac.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "charts.h"
#include "snapshot.h"

namespace hfrac::viz {

namespace {

// The engine's (Aki 1965, from the fullest tenth of a magnitude on): the number printed by `hfrac catalogue`.
hfrac_magnitude_law law_of(const std::vector<double>& magnitudes) {
  hfrac_magnitude_law law{};
  law.struct_size = static_cast<std::int32_t>(sizeof law);
  const double fullest = std::numeric_limits<double>::quiet_NaN();
  if (hfrac_find_magnitude_law(magnitudes.data(), static_cast<std::int64_t>(magnitudes.size()), fullest,
                               &law) != HFRAC_OK)
    law.b = 0;
  return law;
}

}  // namespace

Panel course_panel(std::vector<ChartSeries> kinds) {
  Panel panel{"Magnitude against time", "time (s)", {}, false, false};
  panel.free_zero = true;
  for (ChartSeries& series : kinds) {
    if (series.x.empty()) continue;
    series.dots = true;
    panel.series.push_back(std::move(series));
  }
  return panel;
}

Panel frequency_panel(const std::string& title, std::vector<double> magnitudes) {
  constexpr std::int64_t fewest = 10;  // for a line
  std::sort(magnitudes.begin(), magnitudes.end());
  ChartSeries frequency{"", "", palette().water, {}, {}};
  frequency.dots = true;
  for (std::size_t i = 0; i < magnitudes.size(); ++i) {
    frequency.x.push_back(magnitudes[i]);
    frequency.y.push_back(static_cast<double>(magnitudes.size() - i));
  }
  Panel panel{title, "magnitude", {frequency}, true, false};
  const hfrac_magnitude_law law = law_of(magnitudes);
  if (!(law.b > 0) || law.count < fewest) return panel;
  ChartSeries line{"b = " + value_text(law.b) + " \xC2\xB1 " + value_text(law.b_error) + " above M " +
                       value_text(law.completeness) + " (Aki 1965)",
                   "",
                   palette().pull,
                   {},
                   {}};
  const auto count = static_cast<double>(law.count);
  line.x = {law.completeness, law.completeness + std::log10(count) / law.b};
  line.y = {count, 1};
  panel.series.push_back(std::move(line));
  return panel;
}

namespace {

struct LoggedEvent {
  Point place;           // [m]
  double time = 0;       // [s]
  double magnitude = 0;  // of the moment
  double moment = 0;     // [N m]
  double isotropic = 0;  // -1 to 1
  bool slip = false;     // of joints
};

std::vector<LoggedEvent> logged_events(const TableFile& table) {
  const auto x = table.numbers("x_m");
  const auto y = table.numbers("y_m");
  const auto time = table.numbers("time_s");
  const auto magnitude = table.numbers("magnitude");
  const auto moment = table.numbers("moment_N_m");
  const auto isotropic = table.numbers("isotropic_fraction");
  // Tables of before there were events from slip have no kinds.
  const auto kind = table.has("kind") ? table.words("kind") : std::vector<std::string>(table.rows());
  std::vector<LoggedEvent> events;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (!std::isfinite(x[i] + y[i] + time[i] + magnitude[i] + moment[i] + isotropic[i])) continue;
    events.push_back({{x[i], y[i]}, time[i], magnitude[i], moment[i], isotropic[i], kind[i] == "slip"});
  }
  return events;
}

// Feignier and Young (1992): above 0.3 volume was gained, below -0.3 lost, between them the rock sheared. Slips of joints
// only shear.
constexpr std::array<const char*, 4> kinds = {"opening", "shearing", "closing", "slip of joints"};

std::size_t kind_of(const LoggedEvent& event) {
  if (event.slip) return 3;
  if (event.isotropic > 0.3) return 0;
  return event.isotropic < -0.3 ? 2 : 1;
}

Colour colour_of(std::size_t kind) {
  return std::array<Colour, 4>{palette().water, palette().shear, palette().pull, palette().ink}[kind];
}

// The square around all events and wells, a little larger.
Extent extent_of(const std::vector<LoggedEvent>& events, const RunFolder& run) {
  Bounds bounds;
  for (const LoggedEvent& event : events) bounds.include(event.place);
  for (const WellPlace& well : run.wells) bounds.include({well.x, well.y}, well.radius);
  if (bounds.empty()) return {0, 0, 1, 1};
  const double side = std::max({1.16 * bounds.width(), 1.16 * bounds.height(), 1e-6});
  return {bounds.middle().x - side / 2, bounds.middle().y - side / 2, side, side};
}

// A series without points for each kind there is: its name stands above the panel.
std::vector<ChartSeries> names_of_kinds(const std::vector<LoggedEvent>& events) {
  std::vector<ChartSeries> names;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const bool there = std::any_of(events.begin(), events.end(),
                                   [&](const LoggedEvent& event) { return kind_of(event) == kind; });
    if (there) names.push_back({kinds[kind], "", colour_of(kind), {}, {}});
  }
  return names;
}

// Areas as moments; the smallest can still be seen.
void put_map(ChartPage& page, const Box& box, const std::vector<LoggedEvent>& events, const RunFolder& run) {
  constexpr double largest_radius = 34;
  constexpr double smallest_radius = 2.5;
  const Extent extent = extent_of(events, run);
  Panel panel{"Where; areas as moments", "x (m)", names_of_kinds(events), false, false};
  panel.unit = "y (m)";
  panel.shown = extent;
  page.panel(box, panel);
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

std::vector<ChartSeries> course_of(const std::vector<LoggedEvent>& events) {
  std::vector<ChartSeries> series;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) series.push_back({"", "", colour_of(kind), {}, {}});
  for (const LoggedEvent& event : events) {
    series[kind_of(event)].x.push_back(event.time);
    series[kind_of(event)].y.push_back(event.magnitude);
  }
  return series;
}

double distance_from_well(const LoggedEvent& event, const RunFolder& run) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const WellPlace& well : run.wells)
    nearest = std::min(nearest, std::hypot(event.place.x - well.x, event.place.y - well.y));
  return nearest;
}

void put_spreading(ChartPage& page, const Box& box, const std::vector<LoggedEvent>& events,
                   const ChartData& data) {
  if (data.run->wells.empty()) return;
  std::vector<DistantEvent> distant;
  std::vector<Colour> colours;
  distant.reserve(events.size());
  for (const LoggedEvent& event : events)
    distant.push_back({event.time, distance_from_well(event, *data.run), kind_of(event)});
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) colours.push_back(colour_of(kind));
  page.panel(box, spreading_panel(distant, colours, data.diffusivity));
}

}  // namespace

void fill_catalogue(ChartPage& page, const ChartData& data) {
  const std::vector<LoggedEvent> events = logged_events(*data.events);
  put_heading(page, *data.run,
              "Seismic catalogue: " + counted(static_cast<std::int64_t>(events.size()), "event"));
  page.text(96, 128,
            "Cracks that broke together (Hazzard and Young 2000). Moment: force drop of their bonds times "
            "lever arm.",
            {18, palette().faint_ink});
  if (std::any_of(events.begin(), events.end(), [](const LoggedEvent& event) { return event.slip; }))
    page.text(96, 156,
              "Joints that slipped together, fast or slowly. Moment: shear modulus times area times slip.",
              {18, palette().faint_ink});
  put_map(page, {130, 270, 690, 690}, events, *data.run);
  page.panel({970, 270, 550, 250}, course_panel(course_of(events)));
  std::vector<double> magnitudes;
  magnitudes.reserve(events.size());
  for (const LoggedEvent& event : events) magnitudes.push_back(event.magnitude);
  page.panel({970, 710, 550, 250}, frequency_panel("Events at least as strong", std::move(magnitudes)));
  put_spreading(page, {130, 1150, 1390, 290}, events, data);
}

}  // namespace hfrac::viz
