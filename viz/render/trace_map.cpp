// SPDX-License-Identifier: BSD-3-Clause
#include "trace_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "charts.h"
#include "failure.h"
#include "number_text.h"
#include "rose.h"
#include "run/text.hpp"

namespace hfrac::viz {
namespace {

constexpr std::int64_t most_traces = 100000;
constexpr std::int32_t most_sets = 12;

struct DrawnTrace {
  Point from, to;  // [m]
  std::size_t set = 0;
  double length() const { return std::hypot(to.x - from.x, to.y - from.y); }
};

std::vector<DrawnTrace> traces_of(const double* ends, const std::int32_t* sets, std::int64_t count) {
  if (count < 1 || count > most_traces)
    fail_argument("count is " + std::to_string(count) + "; allowed: 1 to " + std::to_string(most_traces));
  if (ends == nullptr) fail_argument("ends is NULL");
  std::vector<DrawnTrace> traces;
  for (std::int64_t i = 0; i < count; ++i) {
    const double* at = ends + 4 * i;
    const std::int32_t set = sets == nullptr ? 0 : sets[i];
    if (!std::isfinite(at[0] + at[1] + at[2] + at[3]))
      fail_argument("trace " + std::to_string(i) + " has an end that is not a finite number");
    if (set < 0 || set >= most_sets)
      fail_argument("sets[" + std::to_string(i) + "] is " + std::to_string(set) + "; allowed: 0 to " +
                    std::to_string(most_sets - 1));
    traces.push_back({{at[0], at[1]}, {at[2], at[3]}, static_cast<std::size_t>(set)});
  }
  return traces;
}

std::size_t sets_of(const std::vector<DrawnTrace>& traces) {
  std::size_t last = 0;
  for (const DrawnTrace& trace : traces) last = std::max(last, trace.set);
  return last + 1;
}

Extent frame_of(const std::vector<DrawnTrace>& traces, const hfrac_viz_trace_options& options) {
  if (options.frame_width > 0 && options.frame_height > 0)
    return {options.left, options.bottom, options.frame_width, options.frame_height};
  Bounds bounds;
  for (const DrawnTrace& trace : traces) {
    bounds.include(trace.from);
    bounds.include(trace.to);
  }
  const double least = 1e-3 * std::max({bounds.width(), bounds.height(), 1e-6});  // of a row of traces
  const double width = std::max(bounds.width(), least), height = std::max(bounds.height(), least);
  return {bounds.middle().x - width / 2, bounds.middle().y - height / 2, width, height};
}

void put_map(ChartPage& page, const std::vector<DrawnTrace>& traces, const Extent& frame) {
  constexpr double room = 690;
  const double scale = room / std::max(frame.width, frame.height);
  const Box box{130, 240, frame.width * scale, frame.height * scale};
  Panel panel{"Traces", "x (m)", {}, false, false};
  for (std::size_t k = 0; k < sets_of(traces) && sets_of(traces) > 1; ++k)
    panel.series.push_back({"set " + std::to_string(k + 1), "", categorical(k), {}, {}});
  panel.unit = "y (m)";
  panel.shown = frame;
  page.panel(box, panel);
  const auto on_page = [&](Point place) {
    return Point{box.left + (place.x - frame.left) * scale, box.bottom() - (place.y - frame.bottom) * scale};
  };
  const double thickness = traces.size() > 1000 ? 1.2 : 2.4;
  for (const DrawnTrace& trace : traces)
    page.line({on_page(trace.from), on_page(trace.to)}, thickness, categorical(trace.set));
}

void put_directions(ChartPage& page, const std::vector<DrawnTrace>& traces) {
  constexpr int bins = 18;
  constexpr double pi = std::numbers::pi;
  RoseBins metres(bins, std::vector<double>(sets_of(traces), 0.0));
  std::vector<Colour> colours;
  for (std::size_t k = 0; k < sets_of(traces); ++k) colours.push_back(categorical(k));
  for (const DrawnTrace& trace : traces) {
    const double way = std::atan2(trace.to.y - trace.from.y, trace.to.x - trace.from.x);
    const double half = std::fmod(way + 2 * pi, pi);
    metres[static_cast<std::size_t>(std::min(bins - 1, static_cast<int>(half / pi * bins)))][trace.set] +=
        trace.length();
  }
  page.text(970, 192, "Directions, by length", {24, palette().ink, true});
  const RoseScale scale = put_rose(page, {1245, 410}, 160, metres, colours);
  page.text(1245, 640, "Metres per 10\xC2\xB0; rings every " + scale.ring + " m. 0\xC2\xB0 is the x axis.",
            {18, palette().faint_ink, false, Align::centre});
}

void put_lengths(ChartPage& page, const std::vector<DrawnTrace>& traces,
                 const hfrac_viz_trace_options& options) {
  ChartSeries found{"traces", "", palette().water, {}, {}};
  found.dots = true;
  found.dot_radius = 4;
  for (const DrawnTrace& trace : traces) found.x.push_back(trace.length());
  std::sort(found.x.begin(), found.x.end());
  for (std::size_t i = 0; i < found.x.size(); ++i) found.y.push_back(static_cast<double>(found.x.size() - i));
  Panel panel{"At least as long", "length (m)", {found}, true, false};
  if (options.given_points > 0) {
    ChartSeries given{"as asked, before they are cut", "", palette().pull, {}, {}};
    given.x.assign(options.given_lengths, options.given_lengths + options.given_points);
    given.y.assign(options.given_counts, options.given_counts + options.given_points);
    panel.series.push_back(std::move(given));
  }
  page.panel({970, 740, 550, 190}, panel);
}

}  // namespace

void render_traces(const double* ends, const std::int32_t* sets, std::int64_t count,
                   const std::filesystem::path& target, const hfrac_viz_trace_options& options) {
  const std::vector<DrawnTrace> traces = traces_of(ends, sets, count);
  const Extent frame = frame_of(traces, options);
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  const auto window = make_offscreen_window();
  const std::string title =
      options.title != nullptr && options.title[0] != 0 ? printable(options.title) : "Natural fractures";
  double length = 0;
  for (const DrawnTrace& trace : traces) length += trace.length();
  const std::string what = counted(count, "trace") + ", " + value_text(length) + " m; P21 " +
                           value_text(length / (frame.width * frame.height)) + " 1/m";
  const PageContent content{title, 1040, [&](ChartPage& page) {
                              put_heading(page, title, what);
                              put_map(page, traces, frame);
                              put_directions(page, traces);
                              put_lengths(page, traces, options);
                            }};
  write_page(target, content, window, {options.width, options.dots_per_inch});
}

}  // namespace hfrac::viz
