// SPDX-License-Identifier: BSD-3-Clause
// hfrac render: pictures and a movie of a run folder, or chosen views of it, drawn without a display.
#include <fmt/format.h>
#include <hfrac/viz.h>

#include <algorithm>
#include <array>

#include "command/commands.hpp"
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"
#include "command/view_request.hpp"

namespace hfrac::command {
namespace {

struct RenderRequest {
  std::string folder;
  int32_t width = 0;   ///< [pixel]; 0: the renderer's own choice
  int32_t height = 0;  ///< [pixel]; 0: as the model's shape asks
  std::string movie;   ///< only this file, .mp4 or .webp
  bool no_movie = false;
  bool quiet = false;
  ViewRequest view;  ///< of one picture instead of all
};

int32_t show_drawing(void* line, double fraction, const char* what) {
  static_cast<ProgressLine*>(line)->show(
      fmt::format("drawing {:3.0f} %  {}", fraction * 100.0, what ? what : ""));
  return interrupted() ? 1 : 0;
}

ExitCode render(const RenderRequest& request) {
  hfrac_viz_options options{};
  options.struct_size = static_cast<int32_t>(sizeof options);
  hfrac_viz_options_init(&options, sizeof options);
  if (request.width > 0) options.width = request.width;
  if (request.height > 0) options.height = request.height;
  if (request.no_movie) options.pictures &= ~static_cast<int32_t>(HFRAC_VIZ_MOVIE);

  if (!request.view.names.empty()) {
    draw_views(request.folder, request.view, request.width, request.height);
    if (!request.quiet) fmt::print("{}\n", request.view.target);
    return kGood;
  }
  catch_interrupts();
  ProgressLine line(request.quiet);
  std::array<char, 2048> error{};
  const auto capacity = static_cast<int32_t>(error.size());
  const char* folder = request.folder.c_str();
  if (!request.movie.empty() && request.width > 0)
    options.movie_width = std::min(request.width / 2 * 2, 4096);
  const int32_t status =
      request.movie.empty()
          ? hfrac_viz_render_run(folder, &options, show_drawing, &line, error.data(), capacity, nullptr)
          : hfrac_viz_render_movie(folder, request.movie.c_str(), &options, show_drawing, &line, error.data(),
                                   capacity, nullptr);
  line.end();
  if (status == HFRAC_STOPPED) {
    fmt::print(stderr, "hfrac: interrupted; the pictures finished so far stay\n");
    return kInterrupted;
  }
  if (status == HFRAC_VIZ_ERR_READ || status == HFRAC_ERR_ARGUMENT) throw BadInput(error.data());
  if (status < 0) throw std::runtime_error(error.data());
  if (!request.quiet && request.movie.empty()) fmt::print("pictures are in {}/pictures\n", request.folder);
  if (!request.quiet && !request.movie.empty()) fmt::print("{}\n", request.movie);
  return kGood;
}

}  // namespace

void add_render(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("render", "Draw the pictures and the movie of a run into DIR/pictures");
  auto request = std::make_shared<RenderRequest>();
  command->add_option("DIR", request->folder, "Run folder")->required();
  command->add_option("--width", request->width, "Width of the pictures in pixels")
      ->check(CLI::Range(320, 8192));
  command->add_option("--height", request->height, "Height of the pictures in pixels")
      ->check(CLI::Range(240, 8192));
  command->add_option("--movie", request->movie,
                      "Only a movie, to this file: .mp4, or .webp, an animated picture for small sizes");
  command->add_flag("--no-movie", request->no_movie, "Pictures only");
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  add_view_options(*command, request->view);
  command->callback([request, &action] { action = [request] { return render(*request); }; });
}

}  // namespace hfrac::command
