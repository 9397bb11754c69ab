// SPDX-License-Identifier: BSD-3-Clause
// The C interface: arguments in, a status out. What is drawn is told by the headers named here.
#include <vtkVersion.h>

#include <string>
#include <vector>

#include "charts.h"
#include "comparison.h"
#include "failure.h"
#include "guarded_call.h"
#include "hfrac/viz.h"
#include "movie_file.h"
#include "offscreen_window.h"
#include "options.h"
#include "paraview_script.h"
#include "render_run.h"
#include "report.h"
#include "run/run_folder.hpp"
#include "snapshot.h"
#include "trace_map.h"
#include "view_layers.h"
#include "view_page.h"

using namespace hfrac::viz;

namespace {

constexpr std::int32_t most_views = 9;

Progress wrapped(hfrac_viz_progress_fn progress, void* user) {
  if (progress == nullptr) return {};
  return [progress, user](double fraction, const std::string& what) {
    return progress(user, fraction, what.c_str()) != 0;
  };
}

std::vector<ViewSpec> specs_of(const char* const* views, std::int32_t count) {
  if (views == nullptr) fail_argument("views is NULL");
  check_range("view_count", count, 1, most_views);
  std::vector<ViewSpec> specs;
  specs.reserve(static_cast<std::size_t>(count));
  for (std::int32_t i = 0; i < count; ++i)
    specs.push_back(view_named(required_text(views[i], "a view's name")));
  return specs;
}

RunFolder run_at(const char* run_dir) {
  return open_run(required_text(run_dir, "run_dir"));
}

}  // namespace

extern "C" {

int32_t hfrac_viz_last_error(char* buffer, int32_t capacity, int32_t* needed) {
  copy_text(last_error(), buffer, capacity, needed);
  return HFRAC_OK;
}

int32_t hfrac_viz_options_init(hfrac_viz_options* options, int32_t struct_size) {
  return init_options(options, struct_size);
}

int32_t hfrac_viz_chart_options_init(hfrac_viz_chart_options* options, int32_t struct_size) {
  return init_options(options, struct_size);
}

int32_t hfrac_viz_comparison_options_init(hfrac_viz_comparison_options* options, int32_t struct_size) {
  return init_options(options, struct_size);
}

int32_t hfrac_viz_trace_options_init(hfrac_viz_trace_options* options, int32_t struct_size) {
  return init_options(options, struct_size);
}

int32_t hfrac_viz_view_options_init(hfrac_viz_view_options* options, int32_t struct_size) {
  return init_options(options, struct_size);
}

int32_t hfrac_viz_render_run(const char* run_dir, const hfrac_viz_options* options,
                             hfrac_viz_progress_fn progress, void* user) {
  return call(
      [&] { render_run(required_text(run_dir, "run_dir"), read_options(options), wrapped(progress, user)); });
}

int32_t hfrac_viz_render_picture(const char* run_dir, int32_t picture, const char* path,
                                 const hfrac_viz_options* options) {
  return call([&] {
    render_picture(required_text(run_dir, "run_dir"), picture, required_text(path, "path"),
                   read_options(options));
  });
}

int32_t hfrac_viz_render_movie(const char* run_dir, const char* path, const hfrac_viz_options* options,
                               hfrac_viz_progress_fn progress, void* user) {
  return call([&] {
    render_movie(required_text(run_dir, "run_dir"), required_text(path, "path"), read_options(options),
                 wrapped(progress, user));
  });
}

int32_t hfrac_viz_render_charts(const char* run_dir, const hfrac_viz_chart_options* options,
                                hfrac_viz_progress_fn progress, void* user) {
  return call([&] { render_charts(run_at(run_dir), read_options(options), wrapped(progress, user)); });
}

int32_t hfrac_viz_render_comparison(const char* table, const char* path,
                                    const hfrac_viz_comparison_options* options) {
  return call([&] {
    render_comparison(required_text(table, "table"), required_text(path, "path"), read_options(options));
  });
}

int32_t hfrac_viz_render_traces(const double* ends, const int32_t* sets, int64_t count, const char* path,
                                const hfrac_viz_trace_options* options) {
  return call([&] { render_traces(ends, sets, count, required_text(path, "path"), read_options(options)); });
}

int32_t hfrac_viz_render_views(const char* run_dir, const char* const* views, int32_t view_count,
                               const char* path, const hfrac_viz_view_options* options) {
  return call([&] {
    const std::vector<ViewSpec> specs = specs_of(views, view_count);
    const std::string target = required_text(path, "path");
    const hfrac_viz_view_options own = read_options(options);
    render_views(run_at(run_dir), specs, target, own);
  });
}

int32_t hfrac_viz_render_sim(hfrac_sim* sim, const char* const* views, int32_t view_count, const char* path,
                             const hfrac_viz_view_options* options) {
  return call([&] {
    const std::vector<ViewSpec> specs = specs_of(views, view_count);
    const std::string target = required_text(path, "path");
    hfrac_viz_view_options own = read_options(options);
    own.snapshot = -1;
    if (sim == nullptr) fail_argument("sim is NULL");
    render_views(run_in_memory(sim), specs, target, own);
  });
}

int32_t hfrac_viz_view_names(char* buffer, int32_t capacity, int32_t* needed) {
  return call([&] { copy_text(view_names(), buffer, capacity, needed); });
}

int32_t hfrac_viz_snapshot_count(const char* run_dir, int32_t* count) {
  return hfrac_viz_snapshots(run_dir, nullptr, 0, count);
}

int32_t hfrac_viz_snapshots(const char* run_dir, int32_t* snapshots, int32_t capacity_snapshots,
                            int32_t* count) {
  return call([&] {
    if (count == nullptr) fail_argument("count is NULL");
    const RunFolder run = run_at(run_dir);
    *count = static_cast<int32_t>(run.discs.size());
    int32_t copied = 0;
    for (const auto& [number, file] : run.discs) {
      if (snapshots == nullptr || copied >= capacity_snapshots) break;
      snapshots[copied++] = static_cast<int32_t>(number);
    }
  });
}

int32_t hfrac_viz_stages(const char* run_dir, int32_t stages[5], int32_t* count) {
  return call([&] {
    if (stages == nullptr || count == nullptr) fail_argument("stages or count is NULL");
    const std::vector<HistoryPoint> history = read_history(run_at(run_dir));
    *count = 0;
    for (const int stage : growth_stages(history))
      stages[(*count)++] = static_cast<int32_t>(history[stage].number);
  });
}

int32_t hfrac_viz_renderer_info(char* buffer, int32_t capacity, int32_t* needed) {
  return call([&] {
    std::string line = make_offscreen_window()->ReportCapabilities();
    line += std::string("; VTK ") + vtkVersion::GetVTKVersion() + "; " + movie_encoder_text();
    copy_text(line, buffer, capacity, needed);
  });
}

int32_t hfrac_viz_write_report(const char* run_dir, const char* path) {
  return call([&] {
    const std::filesystem::path folder = required_text(run_dir, "run_dir");
    const std::filesystem::path target = path != nullptr && path[0] != 0 ? path : folder / "report.html";
    write_whole(target, report_page(folder));
  });
}

int32_t hfrac_viz_write_paraview_script(const char* run_dir) {
  return call([&] {
    const RunFolder run = run_at(run_dir);
    write_whole(run.path / "paraview_state.py", paraview_script(run));
  });
}

}  // extern "C"
