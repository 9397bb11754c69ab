// SPDX-License-Identifier: BSD-3-Clause
// The C interface of the pictures and the movie.
#include <vtkVersion.h>

#include <string>

#include "failure.h"
#include "guarded_call.h"
#include "hfrac/viz.h"
#include "history.h"
#include "offscreen_window.h"
#include "option_struct.h"
#include "render_run.h"
#include "run_folder.h"
#include "video_encoder.h"

namespace hfrac::viz {
namespace {

hfrac_viz_options defaults() {
  hfrac_viz_options options{};
  options.struct_size = static_cast<int32_t>(sizeof options);
  options.struct_version = 1;
  options.pictures = HFRAC_VIZ_ALL;
  options.width = 1600;
  options.movie_width = 1280;
  options.movie_seconds = 12;
  options.snapshot = -1;
  options.formats = HFRAC_VIZ_PNG;
  return options;
}

hfrac_viz_options checked(const hfrac_viz_options* options) {
  const hfrac_viz_options own = read_options("hfrac_viz_options", options, defaults());
  check_range("pictures", own.pictures, 0, HFRAC_VIZ_ALL);
  check_range("width", own.width, 320, 8192);
  check_range("height", own.height, 240, 8192, true);
  check_range("movie_width", own.movie_width, 320, 4096);
  check_range("movie_height", own.movie_height, 240, 4096, true);
  check_range("movie_seconds", own.movie_seconds, 1, 600);
  check_range("dots_per_inch", own.dots_per_inch, 36, 2400, true);
  check_range("formats", own.formats, 1, HFRAC_VIZ_PNG | HFRAC_VIZ_SVG | HFRAC_VIZ_PDF);
  if (own.movie_width % 2 != 0 || own.movie_height % 2 != 0)
    fail_argument("a movie's width and height must be even");
  return own;
}

}  // namespace
}  // namespace hfrac::viz

using namespace hfrac::viz;

extern "C" {

int32_t hfrac_viz_options_init(hfrac_viz_options* options, int32_t struct_size) {
  return init_options(options, struct_size, defaults());
}

int32_t hfrac_viz_render_run(const char* run_dir, const hfrac_viz_options* options,
                             hfrac_viz_progress_fn progress, void* user, char* error, int32_t capacity,
                             int32_t* needed) {
  return call(error, capacity, needed, [&] {
    render_run(required_text(run_dir, "run_dir"), checked(options), wrapped(progress, user));
  });
}

int32_t hfrac_viz_render_picture(const char* run_dir, int32_t picture, const char* path,
                                 const hfrac_viz_options* options, char* error, int32_t capacity,
                                 int32_t* needed) {
  return call(error, capacity, needed, [&] {
    render_picture(required_text(run_dir, "run_dir"), picture, required_text(path, "path"), checked(options));
  });
}

int32_t hfrac_viz_render_movie(const char* run_dir, const char* path, const hfrac_viz_options* options,
                               hfrac_viz_progress_fn progress, void* user, char* error, int32_t capacity,
                               int32_t* needed) {
  return call(error, capacity, needed, [&] {
    render_movie(required_text(run_dir, "run_dir"), required_text(path, "path"), checked(options),
                 wrapped(progress, user));
  });
}

int32_t hfrac_viz_snapshot_count(const char* run_dir, int32_t* count, char* error, int32_t capacity,
                                 int32_t* needed) {
  return hfrac_viz_snapshots(run_dir, nullptr, 0, count, error, capacity, needed);
}

int32_t hfrac_viz_snapshots(const char* run_dir, int32_t* snapshots, int32_t capacity_snapshots,
                            int32_t* count, char* error, int32_t capacity, int32_t* needed) {
  return call(error, capacity, needed, [&] {
    if (count == nullptr) fail_argument("count is NULL");
    const RunFolder run = open_run(required_text(run_dir, "run_dir"));
    *count = static_cast<int32_t>(run.discs.size());
    int32_t copied = 0;
    for (const auto& [number, file] : run.discs) {
      if (snapshots == nullptr || copied >= capacity_snapshots) break;
      snapshots[copied++] = number;
    }
  });
}

int32_t hfrac_viz_stages(const char* run_dir, int32_t stages[5], int32_t* count, char* error,
                         int32_t capacity, int32_t* needed) {
  return call(error, capacity, needed, [&] {
    if (stages == nullptr || count == nullptr) fail_argument("stages or count is NULL");
    const std::vector<HistoryPoint> history = read_history(open_run(required_text(run_dir, "run_dir")));
    *count = 0;
    for (const int stage : growth_stages(history)) stages[(*count)++] = history[stage].number;
  });
}

int32_t hfrac_viz_renderer_info(char* buffer, int32_t capacity, int32_t* needed) {
  std::string line;
  std::string reason;
  const int32_t status = call(nullptr, 0, nullptr, [&] {
    try {
      line = make_offscreen_window()->ReportCapabilities();
      line += std::string("; VTK ") + vtkVersion::GetVTKVersion() + "; " + movie_encoder_text();
    } catch (const std::exception& error) {
      reason = error.what();
      throw;
    }
  });
  copy_text(status == HFRAC_OK ? line : reason, buffer, capacity, needed);
  return status;
}

}  // extern "C"
