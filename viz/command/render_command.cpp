// SPDX-License-Identifier: BSD-3-Clause
// hfrac render: pictures and a movie of a run folder, or chosen views of it, drawn without a display.
#include <fmt/format.h>
#include <hfrac/viz.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "command/commands.hpp"
#include "command/drawing.hpp"
#include "command/exit_code.hpp"
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"
#include "command/standard_streams.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {
namespace {

// Options of `hfrac render` for one picture: which views, of which part, when.

struct ViewRequest {
  std::vector<std::string> names;  ///< of views; empty: the usual pictures are wanted
  std::string zoom = "whole";      ///< a word, or left,bottom,width,height in metres
  std::string target = "view.png";
  int32_t snapshot = -1;
};

/** Draws the picture. Throws BadInput or std::runtime_error. */
void draw_views(const std::string& folder, const ViewRequest& request, const Paper& paper, int32_t height);

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

void add_view_options(CLI::App& command, ViewRequest& request) {
  auto* view = command.add_option(
      "--view", request.names,
      "One picture of these views side by side, up to nine, instead of the usual pictures:\n");
  view->delimiter(',')->expected(1, 9);
  // Their list is the renderer's, which is loaded only where this command was chosen.
  command.preparse_callback(
      [view](std::size_t) { view->description(view->get_description() + view_help()); });
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

struct RenderRequest {
  std::string folder;
  Paper paper;
  int32_t height = 0;  ///< [pixel]; 0: as the model's shape asks
  std::string movie;   ///< only this file, .mp4 or .webp
  bool no_movie = false;
  bool follow = false;  ///< the run goes on: the movie first, until it is over
  bool quiet = false;
  ViewRequest view;  ///< of one picture instead of all
};

/** Where the movie alone goes, empty: nowhere. */
std::string movie_file(const RenderRequest& request) {
  if (!request.movie.empty() || !request.follow) return request.movie;
  const auto pictures = std::filesystem::path(request.folder) / "pictures";
  if (std::error_code error; !std::filesystem::is_directory(request.folder, error))
    throw BadInput(fmt::format("there is no folder '{}'", request.folder));
  std::error_code error;
  std::filesystem::create_directories(pictures, error);
  if (error)
    throw std::runtime_error(fmt::format("cannot make '{}': {}", pictures.string(), error.message()));
  return (pictures / "movie.mp4").string();
}

hfrac_viz_options options_of(const RenderRequest& request) {
  auto options = options_for(request.paper, hfrac_viz_options_init);
  const int32_t width = request.paper.pixels();
  if (request.height > 0) options.height = request.height;
  if (!request.movie.empty() && width > 0) options.movie_width = std::min(width / 2 * 2, 4096);
  if (!request.movie.empty() && request.height > 0)
    options.movie_height = std::min(request.height / 2 * 2, 4096);
  options.movie_follow = request.follow ? 1 : 0;
  if (request.no_movie || request.follow) options.pictures &= ~static_cast<int32_t>(HFRAC_VIZ_MOVIE);
  return options;
}

ExitCode render(const RenderRequest& request) {
  if ((request.paper.svg || request.paper.pdf) && !(request.view.names.empty() && request.movie.empty()))
    throw BadInput(
        "--svg and --pdf are for the usual pictures; of one picture the ending of its name says which kind "
        "of file");
  if (!request.view.names.empty()) {
    draw_views(request.folder, request.view, request.paper, request.height);
    if (!request.quiet) fmt::print("{}\n", request.view.target);
    return kGood;
  }
  const hfrac_viz_options options = options_of(request);
  const std::string movie = movie_file(request);
  catch_interrupts();
  ProgressLine line(request.quiet);
  const char* folder = request.folder.c_str();
  int32_t status = HFRAC_OK;
  if (!movie.empty()) status = hfrac_viz_render_movie(folder, movie.c_str(), &options, show_drawing, &line);
  if (request.movie.empty() && status == HFRAC_OK)
    status = hfrac_viz_render_run(folder, &options, show_drawing, &line);
  line.end();
  if (drawing_stopped(status)) {
    tell("hfrac: interrupted; the pictures finished so far stay\n");
    return kInterrupted;
  }
  if (request.quiet) return kGood;
  if (request.movie.empty())
    fmt::print("pictures are in {}/pictures\n", request.folder);
  else
    fmt::print("{}\n", request.movie);
  return kGood;
}

}  // namespace

void add_render(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("render", "Draw the pictures and the movie of a run into DIR/pictures");
  auto request = std::make_shared<RenderRequest>();
  command->add_option("DIR", request->folder, "Run folder")->required();
  add_paper_options(*command, request->paper);
  command->add_option("--height", request->height, "Height of the pictures in pixels")
      ->check(CLI::Range(240, 8192));
  command->add_option("--movie", request->movie,
                      "Only a movie, to this file: .mp4, or .webp, an animated picture for small sizes");
  auto* no_movie = command->add_flag("--no-movie", request->no_movie, "Pictures only");
  command
      ->add_flag("--follow", request->follow,
                 "The run goes on: make the movie meanwhile, and the pictures when it is over")
      ->excludes(no_movie);
  add_format_options(*command, request->paper);
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  add_view_options(*command, request->view);
  command->callback([request, &action] { action = [request] { return render(*request); }; });
}

}  // namespace hfrac::command
