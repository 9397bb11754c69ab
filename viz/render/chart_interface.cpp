// SPDX-License-Identifier: BSD-3-Clause
// The C interface of the charts: which of them, into which files.
#include <array>

#include "charts.h"
#include "failure.h"
#include "guarded_call.h"
#include "hfrac/viz.h"
#include "option_struct.h"
#include "page_files.h"
#include "whole_file.h"

namespace hfrac::viz {
namespace {

constexpr std::array<Chart, 5> all_charts = {
    {{HFRAC_VIZ_CHART_HISTORY, "history", "The run against time", 1440, fill_history, &ChartData::history},
     {HFRAC_VIZ_CHART_ROSE, "rose", "Directions of the cracks", 1180, fill_rose, &ChartData::cracks},
     {HFRAC_VIZ_CHART_PROFILE, "profile", "Aperture along the fracture", 840, fill_profile,
      &ChartData::cracks},
     {HFRAC_VIZ_CHART_EVENTS, "events", "Magnitudes of the cracks", 790, fill_events, &ChartData::cracks},
     {HFRAC_VIZ_CHART_CATALOGUE, "catalogue", "Seismic catalogue", 1080, fill_catalogue,
      &ChartData::events}}};

hfrac_viz_chart_options defaults() {
  hfrac_viz_chart_options options{};
  options.struct_size = static_cast<int32_t>(sizeof options);
  options.struct_version = 1;
  options.charts = HFRAC_VIZ_CHART_ALL;
  options.formats = HFRAC_VIZ_PNG;
  options.width = 1600;
  return options;
}

hfrac_viz_chart_options checked(const hfrac_viz_chart_options* options) {
  const hfrac_viz_chart_options own = read_options("hfrac_viz_chart_options", options, defaults());
  check_range("charts", own.charts, 0, HFRAC_VIZ_CHART_ALL);
  check_range("formats", own.formats, 1, HFRAC_VIZ_PNG | HFRAC_VIZ_SVG | HFRAC_VIZ_PDF);
  check_range("width", own.width, 320, 8192);
  check_range("dots_per_inch", own.dots_per_inch, 36, 2400, true);
  return own;
}

void draw_chart(const Chart& chart, const ChartData& data, OffscreenWindow* window,
                const hfrac_viz_chart_options& options) {
  const std::filesystem::path stem = data.run->path / "pictures" / chart.name;
  const std::string title = data.run->title.empty() ? chart.title : data.run->title + ": " + chart.title;
  const PageContent content{title, chart.height, [&](ChartPage& page) { chart.fill(page, data); }};
  const PagePixels pixels{options.width, options.dots_per_inch};
  for (const auto& [format, ending] :
       {std::pair{HFRAC_VIZ_PNG, ".png"}, {HFRAC_VIZ_SVG, ".svg"}, {HFRAC_VIZ_PDF, ".pdf"}}) {
    if ((options.formats & format) != 0) write_page(stem.string() + ending, content, window, pixels);
  }
}

void render_charts(const std::filesystem::path& folder, const hfrac_viz_chart_options& options,
                   const Progress& progress) {
  const auto tell = [&](double fraction, const std::string& what) {
    if (progress && progress(fraction, what)) throw Stopped{};
  };
  tell(0.0, "reading");
  const RunFolder run = open_run(folder);
  const ChartData data(run);
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  const auto window = make_offscreen_window();
  make_folder(folder / "pictures");
  double done = 0;
  for (const Chart& chart : all_charts) {
    const bool wanted = (options.charts & chart.kind) != 0;
    if (wanted && (data.*chart.table).rows() > 0) {
      tell(done / all_charts.size(), chart.name);
      draw_chart(chart, data, window, options);
    }
    ++done;
  }
  tell(1.0, "done");
}

}  // namespace
}  // namespace hfrac::viz

using namespace hfrac::viz;

extern "C" {

int32_t hfrac_viz_chart_options_init(hfrac_viz_chart_options* options, int32_t struct_size) {
  return init_options(options, struct_size, defaults());
}

int32_t hfrac_viz_render_charts(const char* run_dir, const hfrac_viz_chart_options* options,
                                hfrac_viz_progress_fn progress, void* user, char* error, int32_t capacity,
                                int32_t* needed) {
  return call(error, capacity, needed, [&] {
    render_charts(required_text(run_dir, "run_dir"), checked(options), wrapped(progress, user));
  });
}

}  // extern "C"
