// SPDX-License-Identifier: BSD-3-Clause
// hfrac report: a run as one HTML file. Pictures that are not there yet are drawn first.
#include <fmt/format.h>
#include <hfrac/viz.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include <cerrno>
#include <string>
#include <system_error>

#include "command/commands.hpp"
#include "command/drawing.hpp"
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"
#include "command/standard_streams.hpp"

namespace hfrac::command {
namespace {

// Where pictures of a run are drawn: in the run folder, which keeps them for the next time, or, if that may not be written to,
// in a folder for the time being that shows the run's files by links.

class DrawingFolder {
 public:
  /** Throws std::filesystem::filesystem_error if no such folder can be made. */
  explicit DrawingFolder(const std::filesystem::path& run);
  DrawingFolder(const DrawingFolder&) = delete;
  DrawingFolder& operator=(const DrawingFolder&) = delete;
  ~DrawingFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool own_ = false;  ///< made here, removed at the end
};

namespace fs = std::filesystem;

bool may_write(const fs::path& folder) {
  return ::access(folder.c_str(), W_OK | X_OK) == 0;
}

void link_files(const fs::path& from, const fs::path& to) {
  for (const auto& entry : fs::directory_iterator(from))
    if (entry.is_regular_file())
      fs::create_symlink(fs::canonical(entry.path()), to / entry.path().filename());
}

DrawingFolder::DrawingFolder(const fs::path& run) : path_(run) {
  const fs::path drawn = run / "pictures";
  std::error_code error;
  if (!fs::is_directory(run, error) || may_write(fs::exists(drawn, error) ? drawn : run)) return;
  std::string name = (fs::temp_directory_path() / "hfrac-report-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw fs::filesystem_error("cannot make a folder to draw in", name,
                               std::error_code(errno, std::generic_category()));
  path_ = name;
  own_ = true;
  fs::create_directory(path_ / "pictures");
  link_files(run, path_);
  if (fs::exists(drawn, error)) link_files(drawn, path_ / "pictures");
}

DrawingFolder::~DrawingFolder() {
  std::error_code ignored;
  if (own_) fs::remove_all(path_, ignored);
}

struct ReportRequest {
  std::string folder;
  std::string target;  ///< empty: report.html in the run folder
  int32_t width = 1200;
  bool no_movie = false;
  bool fresh = false;  ///< draw everything again
  bool quiet = false;
};

bool older_than_data(const std::string& folder, const char* picture) {
  std::error_code error;
  const auto data = fs::last_write_time(fs::path(folder) / "discs.pvd", error);
  const auto made = fs::last_write_time(fs::path(folder) / "pictures" / picture, error);
  return error || made < data;
}

/** Four views of the end, close up. A run folder may lack what one of them needs; the report is then without them. */
void draw_around_cracks(const ReportRequest& request) {
  hfrac_viz_view_options options{};
  hfrac_viz_view_options_init(&options, sizeof options);
  options.width = std::max(request.width, 1600);
  options.zoom = HFRAC_VIZ_ZOOM_CRACKS;
  const std::array<const char*, 4> views = {"forces", "stress", "displacement", "crack-time"};
  const auto target = (fs::path(request.folder) / "pictures" / "views.png").string();
  const int32_t status = hfrac_viz_render_views(request.folder.c_str(), views.data(),
                                                static_cast<int32_t>(views.size()), target.c_str(), &options);
  if (status == HFRAC_VIZ_ERR_READ)
    fmt::print(stderr, "hfrac: warning: no views around the cracks: {}\n", drawing_error());
  else
    drawing_stopped(status);
}

/** The pictures that are missing, or older than the last snapshot. */
int32_t wanted_pictures(const ReportRequest& request) {
  struct Drawn {
    int32_t kind;
    const char* name;
  };
  static constexpr std::array<Drawn, 5> drawn = {{{HFRAC_VIZ_MODEL, "model.png"},
                                                  {HFRAC_VIZ_GROWTH, "growth.png"},
                                                  {HFRAC_VIZ_PRESSURE, "pressure.png"},
                                                  {HFRAC_VIZ_APERTURE, "aperture.png"},
                                                  {HFRAC_VIZ_MOVIE, "movie.mp4"}}};
  int32_t wanted = 0;
  for (const Drawn& picture : drawn) {
    if (request.no_movie && picture.kind == HFRAC_VIZ_MOVIE) continue;
    if (request.fresh || older_than_data(request.folder, picture.name)) wanted |= picture.kind;
  }
  return wanted;
}

ExitCode report(ReportRequest request) {
  catch_interrupts();
  const std::string target =
      request.target.empty() ? (fs::path(request.folder) / "report.html").string() : request.target;
  const DrawingFolder drawing(request.folder);
  request.folder = drawing.path().string();
  ProgressLine line(request.quiet);
  hfrac_viz_options pictures{};
  hfrac_viz_options_init(&pictures, sizeof pictures);
  pictures.width = request.width;
  pictures.pictures = wanted_pictures(request);
  hfrac_viz_chart_options charts{};
  hfrac_viz_chart_options_init(&charts, sizeof charts);
  charts.formats = HFRAC_VIZ_SVG;
  const char* folder = request.folder.c_str();
  const bool interrupt = (pictures.pictures != 0 &&
                          drawing_stopped(hfrac_viz_render_run(folder, &pictures, show_drawing, &line))) ||
                         drawing_stopped(hfrac_viz_render_charts(folder, &charts, show_drawing, &line));
  if (!interrupt && (request.fresh || older_than_data(request.folder, "views.png")))
    draw_around_cracks(request);
  line.end();
  if (interrupt) {
    tell("hfrac: interrupted; no report was written\n");
    return kInterrupted;
  }
  drawing_stopped(hfrac_viz_write_report(folder, target.c_str()));
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
