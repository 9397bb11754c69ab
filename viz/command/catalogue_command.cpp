// SPDX-License-Identifier: BSD-3-Clause
// hfrac catalogue: the cracks of a run as seismic events: events.csv, a picture, the law of their magnitudes.
#include <fmt/format.h>
#ifdef HFRAC_WITH_RENDERER
#include <hfrac/viz.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "command/commands.hpp"
#include "output/tables.hpp"
#include "run/files.hpp"
#ifdef HFRAC_WITH_RENDERER
#include "command/drawing.hpp"
#endif

namespace hfrac::command {
namespace {

struct CatalogueRequest {
  std::string folder;
  double distance = 0.0;      ///< [m]
  double time_window = 0.0;   ///< [s]
  int64_t cycle_window = 0;   ///< mechanical cycles
  double thickness = 1.0;     ///< [m]
  double completeness = NAN;  ///< magnitude
  bool quiet = false;
#ifdef HFRAC_WITH_RENDERER
  Paper paper;
#endif
};

void say(const CatalogueRequest& request, const std::vector<hfrac_event>& events, int64_t cracks) {
  fmt::print("{}\n  {:18} {} of {} cracks\n", request.folder, "events", events.size(), cracks);
  if (events.empty()) return;
  const auto& largest = *std::max_element(events.begin(), events.end(),
                                          [](const auto& a, const auto& b) { return a.moment < b.moment; });
  double moment = 0.0;
  double energy = 0.0;
  std::vector<double> magnitudes;
  for (const auto& event : events) {
    moment += event.moment;
    energy += event.energy;
    magnitudes.push_back(event.magnitude);
  }
  fmt::print("  {:18} M {:.2f}, {} cracks, {:.4g} N m, at {:.4g}, {:.4g} m, {:.4g} s\n", "largest",
             largest.magnitude, largest.crack_count, largest.moment, largest.position[0], largest.position[1],
             largest.time);
  fmt::print("  {:18} moment {:.4g} N m, energy {:.4g} J, for {:g} m of thickness\n", "all together", moment,
             energy, request.thickness);
  auto law = output::sized<hfrac_magnitude_law>();
  output::require(hfrac_find_magnitude_law(magnitudes.data(), static_cast<int64_t>(magnitudes.size()),
                                           request.completeness, &law),
                  nullptr);
  if (law.b > 0.0)
    fmt::print("  {:18} {:.2f} +- {:.2f} (Aki 1965), {} events from M {:.2f} on\n", "b", law.b, law.b_error,
               law.count, law.completeness);
}

#ifdef HFRAC_WITH_RENDERER
void draw(const CatalogueRequest& request) {
  auto options = options_for(request.paper, hfrac_viz_chart_options_init);
  options.charts = HFRAC_VIZ_CHART_CATALOGUE;
  drawing_stopped(hfrac_viz_render_charts(request.folder.c_str(), &options, nullptr, nullptr));
}
#endif

ExitCode catalogue(const CatalogueRequest& request) {
  const std::filesystem::path folder = request.folder;
  if (std::error_code error; !std::filesystem::is_regular_file(folder / "cracks.csv", error))
    throw BadInput(fmt::format("'{}' is not a run folder: it has no cracks.csv", request.folder));
  std::vector<hfrac_crack> cracks;
  try {
    cracks = output::read_crack_table(folder / "cracks.csv");
  } catch (const output::FileError& error) {
    throw BadInput(error.what());
  }
  auto options = output::sized<hfrac_catalogue_options>();
  options.distance = request.distance;
  options.time_window = request.time_window;
  options.cycle_window = request.cycle_window;
  options.thickness = request.thickness;
  const auto events = output::events_of(cracks, &options);
  output::write_whole(folder / "events.csv", output::event_table(events));
#ifdef HFRAC_WITH_RENDERER
  if (!events.empty()) draw(request);
#endif
  if (!request.quiet) say(request, events, static_cast<int64_t>(cracks.size()));
  return kGood;
}

}  // namespace

void add_catalogue(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "catalogue", "Seismic events of a run: events.csv, a picture, magnitudes and their b value");
  auto request = std::make_shared<CatalogueRequest>();
  command->add_option("DIR", request->folder, "Run folder")->required();
  const auto positive = CLI::Range(0.0, 1e12);
  command
      ->add_option("--distance", request->distance,
                   "Metres between cracks of one event; 0: two mean disc distances")
      ->check(positive);
  command->add_option("--seconds", request->time_window, "Seconds between them; 0: the same step")
      ->check(positive);
  command->add_option("--cycles", request->cycle_window, "Mechanical cycles between them; 0: any number")
      ->check(CLI::Range(int64_t{0}, int64_t{1000000000000}));
  command->add_option("--thickness", request->thickness, "Metres of rock that the plane stands for")
      ->check(CLI::Range(1e-9, 1e9))
      ->capture_default_str();
  command
      ->add_option("--completeness", request->completeness,
                   "Magnitude from which on b is found; left out: the fullest tenth")
      ->check(CLI::Range(-20.0, 20.0));
#ifdef HFRAC_WITH_RENDERER
  add_paper_options(*command, request->paper);
  add_format_options(*command, request->paper);
#endif
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  command->callback([request, &action] { action = [request] { return catalogue(*request); }; });
}

}  // namespace hfrac::command
