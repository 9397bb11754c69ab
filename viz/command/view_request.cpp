// SPDX-License-Identifier: BSD-3-Clause
#include "command/view_request.hpp"

#include <fmt/format.h>
#include <hfrac/viz.h>

#include <array>
#include <map>

#include "command/exit_code.hpp"

namespace hfrac::command {
namespace {

constexpr int32_t print_resolution = 300;  // [dots per inch]

const std::map<std::string, int32_t>& view_names() {
  static const std::map<std::string, int32_t> names = {
      {"discs", HFRAC_VIZ_VIEW_DISCS},           {"forces", HFRAC_VIZ_VIEW_FORCES},
      {"crack-time", HFRAC_VIZ_VIEW_CRACK_TIME}, {"aperture", HFRAC_VIZ_VIEW_APERTURE},
      {"pressure", HFRAC_VIZ_VIEW_PRESSURE},     {"displacement", HFRAC_VIZ_VIEW_DISPLACEMENT},
      {"stress", HFRAC_VIZ_VIEW_STRESS},         {"rotation", HFRAC_VIZ_VIEW_ROTATION}};
  return names;
}

/** "left,bottom,width,height" in metres. */
void set_box(const std::string& text, hfrac_viz_view_options& options) {
  const std::vector<std::string> parts = CLI::detail::split(text, ',');
  const std::array<double*, 4> values = {&options.left, &options.bottom, &options.box_width,
                                         &options.box_height};
  bool good = parts.size() == values.size();
  for (std::size_t i = 0; good && i < values.size(); ++i)
    good = CLI::detail::lexical_cast(parts[i], *values[i]);
  if (!good) {
    throw BadInput(
        fmt::format("--zoom '{}' is neither whole, cracks, well, tip nor left,bottom,width,height", text));
  }
  options.zoom = HFRAC_VIZ_ZOOM_BOX;
}

void set_zoom(const std::string& zoom, hfrac_viz_view_options& options) {
  static const std::map<std::string, int32_t> names = {{"whole", HFRAC_VIZ_ZOOM_WHOLE},
                                                       {"cracks", HFRAC_VIZ_ZOOM_CRACKS},
                                                       {"well", HFRAC_VIZ_ZOOM_WELL},
                                                       {"tip", HFRAC_VIZ_ZOOM_TIP}};
  const auto found = names.find(zoom);
  if (found != names.end()) {
    options.zoom = found->second;
  } else {
    set_box(zoom, options);
  }
}

}  // namespace

void add_view_options(CLI::App& command, ViewRequest& request) {
  std::vector<std::string> names;
  for (const auto& [name, value] : view_names()) names.push_back(name);
  auto* view =
      command
          .add_option("--view", request.names,
                      "One picture of these views side by side, up to nine, instead of the usual pictures")
          ->check(CLI::IsMember(names))
          ->delimiter(',')
          ->expected(1, 9);
  const auto only_with_view = [view](CLI::Option* option) { option->needs(view); };
  only_with_view(
      command.add_option("-o,--output", request.target, "PNG file of that picture")->capture_default_str());
  only_with_view(command.add_option("--zoom", request.zoom,
                                    "whole, cracks, well, tip, or left,bottom,width,height in metres"));
  only_with_view(
      command.add_option("--snapshot", request.snapshot, "Number of the snapshot; the last otherwise")
          ->check(CLI::NonNegativeNumber));
  only_with_view(command.add_flag("--dark", request.dark, "Light on dark paper"));
  only_with_view(command.add_flag("--print", request.print, "Note 300 dots per inch in the file"));
}

void draw_views(const std::string& folder, const ViewRequest& request, int32_t width, int32_t height) {
  hfrac_viz_view_options options{};
  hfrac_viz_view_options_init(&options, sizeof options);
  if (width > 0) options.width = width;
  if (height > 0) options.height = height;
  options.snapshot = request.snapshot;
  options.dark = request.dark ? 1 : 0;
  options.dots_per_inch = request.print ? print_resolution : 0;
  set_zoom(request.zoom, options);
  std::vector<int32_t> views;
  for (const std::string& name : request.names) views.push_back(view_names().at(name));
  std::array<char, 2048> error{};
  const int32_t status = hfrac_viz_render_views(
      folder.c_str(), views.data(), static_cast<int32_t>(views.size()), request.target.c_str(), &options,
      error.data(), static_cast<int32_t>(error.size()), nullptr);
  if (status == HFRAC_VIZ_ERR_READ || status == HFRAC_ERR_ARGUMENT) throw BadInput(error.data());
  if (status < 0) throw std::runtime_error(error.data());
}

}  // namespace hfrac::command
