// SPDX-License-Identifier: BSD-3-Clause
// The C interface: arguments checked, one call at a time, no exception out, every reason into the caller's
// buffer.
#include <vtkVersion.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <mutex>
#include <new>
#include <string>

#include "failure.h"
#include "hfrac/viz.h"
#include "history.h"
#include "movie_file.h"
#include "offscreen_window.h"
#include "render_run.h"
#include "run_folder.h"
#include "vtk_messages.h"

namespace hfrac::viz {
namespace {

// VTK's text cache is shared by the whole process and not guarded.
std::mutex drawing;
thread_local bool inside_call = false;

void copy_text(const std::string& text, char* buffer, std::int32_t capacity, std::int32_t* needed) {
  if (needed != nullptr) *needed = static_cast<std::int32_t>(text.size() + 1);
  if (buffer == nullptr || capacity <= 0) return;
  std::size_t length = std::min(text.size(), static_cast<std::size_t>(capacity) - 1);
  // Do not cut a UTF-8 letter in two.
  while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80)
    --length;
  std::memcpy(buffer, text.data(), length);
  buffer[length] = 0;
}

struct InsideCall {
  InsideCall() { inside_call = true; }
  ~InsideCall() { inside_call = false; }
  InsideCall(const InsideCall&) = delete;
  InsideCall& operator=(const InsideCall&) = delete;
};

// Runs `work`, which may throw anything, and returns the status; `text` gets the reason.
template <class Work>
std::int32_t guarded(std::string& text, const Work& work) {
  try {
    if (inside_call) {
      text = "called from inside a progress callback of the renderer";
      return HFRAC_ERR_BUSY;
    }
    const std::lock_guard lock(drawing);
    const InsideCall inside;
    VtkMessages messages;
    work();
    return HFRAC_OK;
  } catch (const Stopped&) {
    return HFRAC_STOPPED;
  } catch (const Failure& failure) {
    text = failure.what();
    return failure.status();
  } catch (const std::bad_alloc&) {
    return HFRAC_ERR_MEMORY;
  } catch (const std::exception& error) {
    text = error.what();
    return HFRAC_ERR_INTERNAL;
  } catch (...) {
    text = "an error without a description";
    return HFRAC_ERR_INTERNAL;
  }
}

// As above, with the text copied to the caller.
template <class Work>
std::int32_t call(char* error, std::int32_t capacity, std::int32_t* needed, const Work& work) noexcept {
  try {
    std::string text;
    const std::int32_t status = guarded(text, work);
    if (status == HFRAC_ERR_MEMORY) text = "out of memory";
    copy_text(text, error, capacity, needed);
    return status;
  } catch (...) {
    copy_text({}, error, capacity, needed);
    return HFRAC_ERR_MEMORY;
  }
}

std::string required_text(const char* text, const char* name) {
  if (text == nullptr || text[0] == 0) fail_argument(std::string(name) + " is NULL or empty");
  return text;
}

void check_range(const char* name, int value, int lowest, int highest, bool zero_allowed = false) {
  if ((value >= lowest && value <= highest) || (zero_allowed && value == 0)) return;
  fail_argument(std::string(name) + " is " + std::to_string(value) + "; allowed: " + std::to_string(lowest) +
                " to " + std::to_string(highest) + (zero_allowed ? ", or 0" : ""));
}

hfrac_viz_options checked(const hfrac_viz_options* options) {
  hfrac_viz_options own;
  hfrac_viz_options_init(&own);
  if (options == nullptr) return own;
  if (options->struct_size < static_cast<std::int32_t>(sizeof(hfrac_viz_options))) {
    throw Failure(HFRAC_ERR_STRUCT_SIZE, "options->struct_size is not set by hfrac_viz_options_init");
  }
  own = *options;
  check_range("pictures", own.pictures, 0, HFRAC_VIZ_ALL);
  check_range("width", own.width, 320, 8192);
  check_range("height", own.height, 240, 8192, true);
  check_range("movie_width", own.movie_width, 320, 4096);
  check_range("movie_height", own.movie_height, 240, 4096, true);
  check_range("movie_seconds", own.movie_seconds, 1, 600);
  if (own.movie_width % 2 != 0 || own.movie_height % 2 != 0)
    fail_argument("a movie's width and height must be even");
  return own;
}

Progress wrapped(hfrac_viz_progress_fn progress, void* user) {
  if (progress == nullptr) return {};
  return [progress, user](double fraction, const std::string& what) {
    return progress(user, fraction, what.c_str()) != 0;
  };
}

}  // namespace
}  // namespace hfrac::viz

using namespace hfrac::viz;

extern "C" {

int32_t hfrac_viz_options_init(hfrac_viz_options* options) {
  if (options == nullptr) return HFRAC_ERR_ARGUMENT;
  *options = {};
  options->struct_size = static_cast<int32_t>(sizeof(hfrac_viz_options));
  options->struct_version = 1;
  options->pictures = HFRAC_VIZ_ALL;
  options->width = 1600;
  options->movie_width = 1280;
  options->movie_seconds = 12;
  options->snapshot = -1;
  return HFRAC_OK;
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
