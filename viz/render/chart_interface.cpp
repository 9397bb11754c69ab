// SPDX-License-Identifier: BSD-3-Clause
// The C interface of the charts: which of them, into which files.
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "charts.h"
#include "failure.h"
#include "guarded_call.h"
#include "hfrac/viz.h"
#include "svg_text.h"
#include "vtk_messages.h"
#include "whole_file.h"

namespace hfrac::viz {
namespace {

constexpr std::array<Chart, 4> all_charts = {
    {{HFRAC_VIZ_CHART_HISTORY, "history", "The run against time", 1440, fill_history, false},
     {HFRAC_VIZ_CHART_ROSE, "rose", "Directions of the cracks", 1180, fill_rose, true},
     {HFRAC_VIZ_CHART_PROFILE, "profile", "Aperture along the fracture", 840, fill_profile, true},
     {HFRAC_VIZ_CHART_EVENTS, "events", "Strength of the cracks", 740, fill_events, true}}};

hfrac_viz_chart_options checked(const hfrac_viz_chart_options* options) {
  hfrac_viz_chart_options own;
  hfrac_viz_chart_options_init(&own);
  if (options == nullptr) return own;
  check_struct_size("hfrac_viz_chart_options", options->struct_size, sizeof(hfrac_viz_chart_options));
  own = *options;
  check_range("charts", own.charts, 0, HFRAC_VIZ_CHART_ALL);
  check_range("formats", own.formats, 1, HFRAC_VIZ_PNG | HFRAC_VIZ_SVG | HFRAC_VIZ_PDF);
  check_range("width", own.width, 320, 8192);
  check_range("dots_per_inch", own.dots_per_inch, 36, 2400, true);
  return own;
}

// VTK's exporters write a file of that name; what they complain about makes them fail.
template <class Write>
void export_whole(const std::filesystem::path& target, const Write& write) {
  WholeFile file(target);
  VtkMessages messages;
  write(file.working_path());
  const std::string errors = messages.take_errors();
  std::error_code missing;
  if (!errors.empty()) fail_drawing("drawing failed: " + errors);
  if (std::filesystem::file_size(file.working_path(), missing) == 0 || missing) {
    fail_writing("cannot write " + target.string());
  }
  file.commit();
}

void mend(const std::filesystem::path& path) {
  std::stringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << mended_svg(content.str(), palette().paper);
  file.close();
  if (!file) fail_writing("cannot write " + path.string());
}

Image chart_image(const Chart& chart, const ChartData& data, OffscreenWindow* window, int width) {
  const int factor = width <= 2700 ? 3 : width <= 5400 ? 2 : 1;
  VtkMessages messages;
  // Whole pixels in both directions, whatever the width.
  const double height = std::round(chart.height * width / ChartPage::width) * ChartPage::width / width;
  ChartPage page(window, height, static_cast<double>(width) * factor / ChartPage::width);
  chart.fill(page, data);
  Image image = page.draw(factor);
  const std::string errors = messages.take_errors();
  if (!errors.empty()) fail_drawing("drawing failed: " + errors);
  return image;
}

void draw_chart(const Chart& chart, const ChartData& data, OffscreenWindow* window,
                const hfrac_viz_chart_options& options) {
  const std::filesystem::path stem = data.run->path / "pictures" / chart.name;
  const auto with = [&](const char* ending) { return std::filesystem::path(stem.string() + ending); };
  if ((options.formats & HFRAC_VIZ_PNG) != 0) {
    write_whole(with(".png"), png(chart_image(chart, data, window, options.width), options.dots_per_inch));
  }
  const std::string title = data.run->title.empty() ? chart.title : data.run->title + ": " + chart.title;
  if ((options.formats & HFRAC_VIZ_SVG) != 0) {
    export_whole(with(".svg"), [&](const std::filesystem::path& path) {
      ChartPage page(window, chart.height, 1.0);
      chart.fill(page, data);
      page.write_svg(path, title);
      mend(path);
    });
  }
  if ((options.formats & HFRAC_VIZ_PDF) != 0) {
    export_whole(with(".pdf"), [&](const std::filesystem::path& path) {
      ChartPage page(window, chart.height, 1.0);
      chart.fill(page, data);
      page.write_pdf(path, title);
    });
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
    const TableFile& table = chart.needs_cracks ? data.cracks : data.history;
    if (wanted && table.rows() > 0) {
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

int32_t hfrac_viz_chart_options_init(hfrac_viz_chart_options* options) {
  if (options == nullptr) return HFRAC_ERR_ARGUMENT;
  *options = {};
  options->struct_size = static_cast<int32_t>(sizeof(hfrac_viz_chart_options));
  options->struct_version = 1;
  options->charts = HFRAC_VIZ_CHART_ALL;
  options->formats = HFRAC_VIZ_PNG;
  options->width = 1600;
  return HFRAC_OK;
}

int32_t hfrac_viz_render_charts(const char* run_dir, const hfrac_viz_chart_options* options,
                                hfrac_viz_progress_fn progress, void* user, char* error, int32_t capacity,
                                int32_t* needed) {
  return call(error, capacity, needed, [&] {
    render_charts(required_text(run_dir, "run_dir"), checked(options), wrapped(progress, user));
  });
}

}  // extern "C"
