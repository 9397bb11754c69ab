// SPDX-License-Identifier: BSD-3-Clause
#include "command/view_request.hpp"

#include <fmt/format.h>
#include <hfrac/viz.h>

#include <array>
#include <map>

#include "command/drawing.hpp"
#include "command/exit_code.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {
namespace {

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

std::string view_help() {
  return run::whole_text(hfrac_viz_view_names);
}

}  // namespace

void add_view_options(CLI::App& command, ViewRequest& request) {
  auto* view = command.add_option(
      "--view", request.names,
      "One picture of these views side by side, up to nine, instead of the usual pictures:\n" + view_help());
  view->delimiter(',')->expected(1, 9);
  const auto only_with_view = [view](CLI::Option* option) { option->needs(view); };
  only_with_view(command.add_option("-o,--output", request.target, "That picture, .png, .svg or .pdf")
                     ->capture_default_str());
  only_with_view(command.add_option("--zoom", request.zoom,
                                    "whole, cracks, well, tip, or left,bottom,width,height in metres"));
  only_with_view(
      command.add_option("--snapshot", request.snapshot, "Number of the snapshot; the last otherwise")
          ->check(CLI::NonNegativeNumber));
}

void draw_views(const std::string& folder, const ViewRequest& request, const Paper& paper, int32_t height) {
  auto options = options_for(paper, hfrac_viz_view_options_init);
  if (height > 0) options.height = height;
  options.snapshot = request.snapshot;
  set_zoom(request.zoom, options);
  std::vector<const char*> views;
  for (const std::string& name : request.names) views.push_back(name.c_str());
  const int32_t status = hfrac_viz_render_views(
      folder.c_str(), views.data(), static_cast<int32_t>(views.size()), request.target.c_str(), &options);
  drawing_stopped(status);
}

}  // namespace hfrac::command
