// SPDX-License-Identifier: BSD-3-Clause
// Which charts there are, and into which files they go.
#include <array>
#include <map>

#include "charts.h"
#include "failure.h"
#include "guarded_call.h"

namespace hfrac::viz {
namespace {

template <int height>
double fixed(const ChartData& /*data*/) {
  return height;
}

constexpr std::array<Chart, 5> all_charts = {
    {{HFRAC_VIZ_CHART_HISTORY, "history", "The run against time", fixed<1440>, fill_history,
      &ChartData::history, "history.csv"},
     {HFRAC_VIZ_CHART_ROSE, "rose", "Directions of the cracks", fixed<1180>, fill_rose, &ChartData::cracks,
      "cracks.csv"},
     {HFRAC_VIZ_CHART_PROFILE, "profile", "Aperture along the fracture", profile_height, fill_profile,
      &ChartData::cracks, "cracks.csv"},
     {HFRAC_VIZ_CHART_EVENTS, "events", "Magnitudes of the cracks", fixed<790>, fill_events,
      &ChartData::cracks, "cracks.csv"},
     {HFRAC_VIZ_CHART_CATALOGUE, "catalogue", "Seismic catalogue", fixed<1560>, fill_catalogue,
      &ChartData::events, "events.csv"}}};

void draw_chart(const Chart& chart, const ChartData& data, OffscreenWindow* window,
                const hfrac_viz_chart_options& options) {
  const std::filesystem::path stem = data.run->path / "pictures" / chart.name;
  const std::string title = data.run->title.empty() ? chart.title : data.run->title + ": " + chart.title;
  const PageContent content{title, chart.height(data), [&](ChartPage& page) { chart.fill(page, data); }};
  const PagePixels pixels{options.width, options.dots_per_inch};
  for (const auto& [format, ending] :
       {std::pair{HFRAC_VIZ_PNG, ".png"}, {HFRAC_VIZ_SVG, ".svg"}, {HFRAC_VIZ_PDF, ".pdf"}}) {
    if ((options.formats & format) != 0) write_page(stem.string() + ending, content, window, pixels);
  }
}

// A table that is not there: nothing is left out of a run without events.csv that goes on, since it is written at the end.
void tell_missing(const ChartData& data, const std::map<std::string, std::string>& missing) {
  for (const auto& [table, charts] : missing)
    if (table != "events.csv" || !data.run->going_on)
      leave_out((data.run->path / table).string() + " is missing, so there is no " + charts);
}

}  // namespace

ChartData::ChartData(const RunFolder& folder) : run(&folder) {
  const auto read = [&](const char* name) {
    const auto path = folder.path / name;
    return is_file(path) ? std::optional<TableFile>(path) : std::nullopt;
  };
  history = read("history.csv");
  cracks = read("cracks.csv");
  events = read("events.csv");
}

void render_charts(const RunFolder& run, const hfrac_viz_chart_options& options, const Progress& progress) {
  const auto tell = [&](double fraction, const std::string& what) {
    if (progress && progress(fraction, what)) throw Stopped{};
  };
  tell(0.0, "reading");
  ChartData data(run);
  data.diffusivity = options.diffusivity;
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  const auto window = make_offscreen_window();
  make_folder(run.path / "pictures");
  std::map<std::string, std::string> missing;  // tables, with the charts they are for
  double done = 0;
  for (const Chart& chart : all_charts) {
    if ((options.charts & chart.kind) != 0) {
      const auto& table = data.*chart.table;
      if (table && table->rows() > 0) {
        tell(done / all_charts.size(), chart.name);
        draw_chart(chart, data, window, options);
      } else if (!table) {
        std::string& charts = missing[chart.table_name];
        charts.append(charts.empty() ? "" : ", ").append(chart.name);
      }
    }
    ++done;
  }
  tell_missing(data, missing);
  tell(1.0, "done");
}

}  // namespace hfrac::viz
