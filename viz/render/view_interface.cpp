// SPDX-License-Identifier: BSD-3-Clause
// The C interface of the views.
#include <algorithm>
#include <cmath>

#include "failure.h"
#include "guarded_call.h"
#include "hfrac/viz.h"
#include "option_struct.h"
#include "page_content.h"
#include "view_layers.h"
#include "view_page.h"
#include "vtk_messages.h"
#include "whole_file.h"

namespace hfrac::viz {
namespace {

constexpr int most_views = 9;

hfrac_viz_view_options defaults() {
  hfrac_viz_view_options options{};
  options.struct_size = static_cast<int32_t>(sizeof options);
  options.struct_version = 1;
  options.snapshot = -1;
  options.width = 1600;
  return options;
}

hfrac_viz_view_options checked(const hfrac_viz_view_options* options) {
  const hfrac_viz_view_options own = read_options("hfrac_viz_view_options", options, defaults());
  check_range("width", own.width, 320, 8192);
  check_range("height", own.height, 240, 8192, true);
  check_range("dots_per_inch", own.dots_per_inch, 36, 2400, true);
  check_range("zoom", own.zoom, HFRAC_VIZ_ZOOM_WHOLE, HFRAC_VIZ_ZOOM_BOX);
  if (own.zoom != HFRAC_VIZ_ZOOM_BOX) return own;
  const bool finite = std::isfinite(own.left) && std::isfinite(own.bottom) && std::isfinite(own.box_width) &&
                      std::isfinite(own.box_height);
  if (!finite || !(own.box_width > 0) || !(own.box_height > 0)) {
    fail_argument("the box to zoom on must have finite corners and a positive width and height");
  }
  constexpr double flattest = 20;
  if (std::max(own.box_width, own.box_height) > flattest * std::min(own.box_width, own.box_height)) {
    fail_argument("the box to zoom on is more than 20 times longer than wide");
  }
  return own;
}

std::vector<ViewSpec> checked_views(const std::int32_t* views, std::int32_t count) {
  if (views == nullptr) fail_argument("views is NULL");
  check_range("view_count", count, 1, most_views);
  std::vector<ViewSpec> specs;
  for (std::int32_t i = 0; i < count; ++i) specs.push_back(view_of_kind(views[i]));
  return specs;
}

std::vector<ViewSpec> checked_names(const char* const* names, std::int32_t count) {
  if (names == nullptr) fail_argument("names is NULL");
  check_range("name_count", count, 1, most_views);
  std::vector<ViewSpec> specs;
  for (std::int32_t i = 0; i < count; ++i) specs.push_back(view_named(required_text(names[i], "a name")));
  return specs;
}

void render_views(const std::filesystem::path& folder, const std::vector<ViewSpec>& specs,
                  const std::filesystem::path& target, const hfrac_viz_view_options& options) {
  const std::string ending = picture_ending(target);
  const RunFolder run = open_run(folder);
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  const auto window = make_offscreen_window();
  const Scene scene = load_scene(run, history_point(run, options.snapshot), false, true);
  const Studio studio{window, &run, {options.width, options.height}};
  const Extent extent = zoomed(run, scene, options);
  VtkMessages messages;
  const std::vector<std::uint8_t> content =
      view_file(studio, scene, specs, extent, ending, options.dots_per_inch);
  const std::string errors = messages.take_errors();
  if (!errors.empty()) fail_drawing("drawing failed: " + errors);
  write_whole(target, content);
}

}  // namespace
}  // namespace hfrac::viz

using namespace hfrac::viz;

extern "C" {

int32_t hfrac_viz_view_options_init(hfrac_viz_view_options* options, int32_t struct_size) {
  return init_options(options, struct_size, defaults());
}

int32_t hfrac_viz_render_views(const char* run_dir, const int32_t* views, int32_t view_count,
                               const char* path, const hfrac_viz_view_options* options, char* error,
                               int32_t capacity, int32_t* needed) {
  return call(error, capacity, needed, [&] {
    const std::string folder = required_text(run_dir, "run_dir");
    const std::vector<ViewSpec> specs = checked_views(views, view_count);
    render_views(folder, specs, required_text(path, "path"), checked(options));
  });
}

int32_t hfrac_viz_render_named_views(const char* run_dir, const char* const* names, int32_t name_count,
                                     const char* path, const hfrac_viz_view_options* options, char* error,
                                     int32_t capacity, int32_t* needed) {
  return call(error, capacity, needed, [&] {
    const std::string folder = required_text(run_dir, "run_dir");
    const std::vector<ViewSpec> specs = checked_names(names, name_count);
    render_views(folder, specs, required_text(path, "path"), checked(options));
  });
}

int32_t hfrac_viz_view_names(char* buffer, int32_t capacity, int32_t* needed) {
  std::string text;
  const int32_t status = call(nullptr, 0, nullptr, [&] { text = view_names(); });
  copy_text(text, buffer, capacity, needed);
  return status;
}

}  // extern "C"
