// SPDX-License-Identifier: BSD-3-Clause
// hfrac report: a run as one HTML file. Pictures that are not there yet are drawn first.
#include <fmt/format.h>
#include <hfrac/viz.h>

#include <array>
#include <filesystem>

#include "command/commands.hpp"
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"

namespace hfrac::command {
namespace {

namespace fs = std::filesystem;

struct ReportRequest {
  std::string folder;
  std::string target;  ///< empty: report.html in the run folder
  int32_t width = 1200;
  bool no_movie = false;
  bool fresh = false;  ///< draw everything again
  bool quiet = false;
};

int32_t show_drawing(void* line, double fraction, const char* what) {
  static_cast<ProgressLine*>(line)->show(
      fmt::format("drawing {:3.0f} %  {}", fraction * 100.0, what ? what : ""));
  return interrupted() ? 1 : 0;
}

/** The pictures that are missing, or older than the last snapshot. */
int32_t wanted_pictures(const ReportRequest& request) {
  struct Drawn {
    int32_t kind;
    const char* name;
  };
  static constexpr std::array<Drawn, 5> drawn = {{{HFRAC_VIZ_MODEL, "figure3.png"},
                                                  {HFRAC_VIZ_GROWTH, "growth.png"},
                                                  {HFRAC_VIZ_PRESSURE, "pressure.png"},
                                                  {HFRAC_VIZ_APERTURE, "aperture.png"},
                                                  {HFRAC_VIZ_MOVIE, "movie.mp4"}}};
  std::error_code error;
  const auto data = fs::last_write_time(fs::path(request.folder) / "discs.pvd", error);
  int32_t wanted = 0;
  for (const Drawn& picture : drawn) {
    if (request.no_movie && picture.kind == HFRAC_VIZ_MOVIE) continue;
    const auto made = fs::last_write_time(fs::path(request.folder) / "pictures" / picture.name, error);
    if (request.fresh || error || made < data) wanted |= picture.kind;
  }
  return wanted;
}

/** Throws for a negative status; true if the user stopped it. */
bool stopped(int32_t status, const char* error) {
  if (status == HFRAC_VIZ_ERR_READ || status == HFRAC_ERR_ARGUMENT) throw BadInput(error);
  if (status < 0) throw std::runtime_error(error);
  return status == HFRAC_STOPPED;
}

ExitCode report(const ReportRequest& request) {
  catch_interrupts();
  ProgressLine line(request.quiet);
  std::array<char, 2048> error{};
  const auto capacity = static_cast<int32_t>(error.size());
  hfrac_viz_options pictures{};
  hfrac_viz_options_init(&pictures, sizeof pictures);
  pictures.width = request.width;
  pictures.pictures = wanted_pictures(request);
  hfrac_viz_chart_options charts{};
  hfrac_viz_chart_options_init(&charts, sizeof charts);
  charts.formats = HFRAC_VIZ_SVG;
  const char* folder = request.folder.c_str();
  const bool interrupt =
      (pictures.pictures != 0 &&
       stopped(hfrac_viz_render_run(folder, &pictures, show_drawing, &line, error.data(), capacity, nullptr),
               error.data())) ||
      stopped(hfrac_viz_render_charts(folder, &charts, show_drawing, &line, error.data(), capacity, nullptr),
              error.data());
  line.end();
  if (interrupt) {
    fmt::print(stderr, "hfrac: interrupted; no report was written\n");
    return kInterrupted;
  }
  const std::string target =
      request.target.empty() ? (fs::path(request.folder) / "report.html").string() : request.target;
  stopped(hfrac_viz_write_report(folder, target.c_str(), error.data(), capacity, nullptr), error.data());
  if (!request.quiet) fmt::print("{}\n", target);
  return kGood;
}

}  // namespace

void add_report(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("report", "Write a run as one HTML file with everything in it");
  auto request = std::make_shared<ReportRequest>();
  command->add_option("DIR", request->folder, "Run folder")->required();
  command->add_option("-o,--output", request->target, "The file; DIR/report.html otherwise");
  command->add_option("--width", request->width, "Width of new pictures in pixels")
      ->check(CLI::Range(320, 8192))
      ->capture_default_str();
  command->add_flag("--no-movie", request->no_movie, "Do not make a movie; one that is there is used");
  command->add_flag("--fresh", request->fresh, "Draw every picture again");
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  command->callback([request, &action] { action = [request] { return report(*request); }; });
}

}  // namespace hfrac::command
