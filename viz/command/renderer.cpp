// SPDX-License-Identifier: BSD-3-Clause
// The renderer's functions (hfrac/viz.h), from a library that is loaded when the first of them is called.
//
// It brings VTK, Mesa and some 150 libraries more, which most commands never need: linked, they cost every process 0.05 s and 20 MB of its
// own, also each that sleeps while another has the model (team.hpp).
#include <dlfcn.h>
#include <hfrac/viz.h>

#include <algorithm>
#include <string>
#include <type_traits>

namespace {

constexpr const char* kLibrary = "libhfrac_viz.so.0";

struct Renderer {
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  std::string reason;  ///< why it is not there
  Renderer() {
    if (library != nullptr) return;
    const char* said = dlerror();
    reason = std::string("pictures need the renderer, ") + kLibrary + ", which cannot be loaded (" +
             (said != nullptr ? said : "no reason given") +
             "); install hfrac with it, or draw where it is installed: hfrac render DIR";
  }
};

const Renderer& renderer() {
  static const Renderer loaded;
  return loaded;
}

/** The function of this name there, of the type that the header says. */
template <class... Parameters>
int32_t call(int32_t (* /*like*/)(Parameters...), const char* name,
             std::type_identity_t<Parameters>... arguments) {
  void* function = renderer().library != nullptr ? dlsym(renderer().library, name) : nullptr;
  if (function == nullptr) return HFRAC_VIZ_ERR_DRAW;
  return reinterpret_cast<int32_t (*)(Parameters...)>(function)(arguments...);
}

}  // namespace

extern "C" {

int32_t hfrac_viz_last_error(char* buffer, int32_t capacity, int32_t* needed) {
  if (renderer().library != nullptr)
    return call(hfrac_viz_last_error, "hfrac_viz_last_error", buffer, capacity, needed);
  const std::string& text = renderer().reason;
  if (needed != nullptr) *needed = static_cast<int32_t>(text.size()) + 1;
  if (buffer == nullptr || capacity <= 0) return HFRAC_OK;
  const auto copied = std::min(text.size(), static_cast<std::size_t>(capacity) - 1);
  text.copy(buffer, copied);
  buffer[copied] = '\0';
  return HFRAC_OK;
}

int32_t hfrac_viz_options_init(hfrac_viz_options* options, int32_t struct_size) {
  return call(hfrac_viz_options_init, "hfrac_viz_options_init", options, struct_size);
}

int32_t hfrac_viz_chart_options_init(hfrac_viz_chart_options* options, int32_t struct_size) {
  return call(hfrac_viz_chart_options_init, "hfrac_viz_chart_options_init", options, struct_size);
}

int32_t hfrac_viz_comparison_options_init(hfrac_viz_comparison_options* options, int32_t struct_size) {
  return call(hfrac_viz_comparison_options_init, "hfrac_viz_comparison_options_init", options, struct_size);
}

int32_t hfrac_viz_trace_options_init(hfrac_viz_trace_options* options, int32_t struct_size) {
  return call(hfrac_viz_trace_options_init, "hfrac_viz_trace_options_init", options, struct_size);
}

int32_t hfrac_viz_view_options_init(hfrac_viz_view_options* options, int32_t struct_size) {
  return call(hfrac_viz_view_options_init, "hfrac_viz_view_options_init", options, struct_size);
}

int32_t hfrac_viz_render_run(const char* run_dir, const hfrac_viz_options* options,
                             hfrac_viz_progress_fn progress, void* user) {
  return call(hfrac_viz_render_run, "hfrac_viz_render_run", run_dir, options, progress, user);
}

int32_t hfrac_viz_render_movie(const char* run_dir, const char* path, const hfrac_viz_options* options,
                               hfrac_viz_progress_fn progress, void* user) {
  return call(hfrac_viz_render_movie, "hfrac_viz_render_movie", run_dir, path, options, progress, user);
}

int32_t hfrac_viz_render_charts(const char* run_dir, const hfrac_viz_chart_options* options,
                                hfrac_viz_progress_fn progress, void* user) {
  return call(hfrac_viz_render_charts, "hfrac_viz_render_charts", run_dir, options, progress, user);
}

int32_t hfrac_viz_render_comparison(const char* table, const char* path,
                                    const hfrac_viz_comparison_options* options) {
  return call(hfrac_viz_render_comparison, "hfrac_viz_render_comparison", table, path, options);
}

int32_t hfrac_viz_render_traces(const double* ends, const int32_t* sets, int64_t count, const char* path,
                                const hfrac_viz_trace_options* options) {
  return call(hfrac_viz_render_traces, "hfrac_viz_render_traces", ends, sets, count, path, options);
}

int32_t hfrac_viz_render_views(const char* run_dir, const char* const* views, int32_t view_count,
                               const char* path, const hfrac_viz_view_options* options) {
  return call(hfrac_viz_render_views, "hfrac_viz_render_views", run_dir, views, view_count, path, options);
}

int32_t hfrac_viz_view_names(char* buffer, int32_t capacity, int32_t* needed) {
  return call(hfrac_viz_view_names, "hfrac_viz_view_names", buffer, capacity, needed);
}

int32_t hfrac_viz_write_report(const char* run_dir, const char* path) {
  return call(hfrac_viz_write_report, "hfrac_viz_write_report", run_dir, path);
}

}  // extern "C"
