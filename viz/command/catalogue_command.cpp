// SPDX-License-Identifier: BSD-3-Clause
// hfrac catalogue: the cracks of a run and the slips of its joints as seismic events: events.csv, a picture, the law of their
// magnitudes, QuakeML.
#include <fmt/format.h>
#ifdef HFRAC_WITH_RENDERER
#include <hfrac/viz.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "command/commands.hpp"
#include "output/quakeml.hpp"
#include "output/tables.hpp"
#include "run/files.hpp"
#ifdef HFRAC_WITH_RENDERER
#include "command/drawing.hpp"
#endif

namespace hfrac::command {
namespace {

struct CatalogueRequest {
  std::string folder;
  double distance = 0.0;       ///< [m]
  double time_window = 0.0;    ///< [s]
  int64_t cycle_window = 0;    ///< mechanical cycles
  double thickness = 1.0;      ///< [m]
  double shear_modulus = 0.0;  ///< [Pa]
  double slip_rate = 0.0;      ///< [m/s]
  double completeness = NAN;   ///< magnitude
  std::string quakeml;         ///< file
  std::string start = "1970-01-01T00:00:00Z";
  output::EarthPlace earth;
  bool quiet = false;
#ifdef HFRAC_WITH_RENDERER
  double diffusivity = 0.0;  ///< [m2/s]
  Paper paper;
#endif
};

using Events = std::vector<hfrac_event>;

void say_law(const CatalogueRequest& request, const Events& events, const char* what) {
  std::vector<double> magnitudes;
  for (const auto& event : events) magnitudes.push_back(event.magnitude);
  auto law = output::sized<hfrac_magnitude_law>();
  output::require(hfrac_find_magnitude_law(magnitudes.data(), static_cast<int64_t>(magnitudes.size()),
                                           request.completeness, &law),
                  nullptr);
  if (law.b > 0.0)
    fmt::print("  {:18} {:.2f} +- {:.2f} (Aki 1965), {} events from M {:.2f} on\n", what, law.b, law.b_error,
               law.count, law.completeness);
}

void say_sum(const CatalogueRequest& request, const Events& events) {
  const auto& largest = *std::max_element(events.begin(), events.end(),
                                          [](const auto& a, const auto& b) { return a.moment < b.moment; });
  double moment = 0.0;
  double energy = 0.0;
  for (const auto& event : events) {
    moment += event.moment;
    energy += event.energy;
  }
  const std::string made_of =
      largest.kind == HFRAC_EVENT_SLIP
          ? fmt::format("slip of {:.3g} mm over {:.3g} m", 1e3 * largest.slip, largest.length)
          : fmt::format("{} cracks", largest.crack_count);
  fmt::print("  {:18} M {:.2f}, {}, {:.4g} N m, at {:.4g}, {:.4g} m, {:.4g} s\n", "largest",
             largest.magnitude, made_of, largest.moment, largest.position[0], largest.position[1],
             largest.time);
  fmt::print("  {:18} moment {:.4g} N m, energy {:.4g} J, for {:g} m of thickness\n", "all together", moment,
             energy, request.thickness);
}

void say(const CatalogueRequest& request, const Events& events, size_t cracks, size_t slips) {
  Events of_cracks, of_slips;
  for (const auto& event : events) (event.kind == HFRAC_EVENT_SLIP ? of_slips : of_cracks).push_back(event);
  fmt::print("{}\n  {:18} {} of {} cracks\n", request.folder, "events", of_cracks.size(), cracks);
  if (slips > 0) fmt::print("  {:18} {} of {} slips, slow slip included\n", "", of_slips.size(), slips);
  if (events.empty()) return;
  say_sum(request, events);
  if (!of_cracks.empty() && !of_slips.empty()) {
    say_law(request, of_cracks, "b of cracks");
    say_law(request, of_slips, "b of slips");
  }
  say_law(request, events, "b");
}

void write_quakeml(const CatalogueRequest& request, const Events& events) {
  auto earth = request.earth;
  try {
    earth.start = output::seconds_of_date(request.start);
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());
  }
  auto folder = std::filesystem::absolute(request.folder).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  output::write_whole(request.quakeml, output::quakeml_text(events, earth, folder.filename().string()));
}

#ifdef HFRAC_WITH_RENDERER
void draw(const CatalogueRequest& request) {
  auto options = options_for(request.paper, hfrac_viz_chart_options_init);
  options.charts = HFRAC_VIZ_CHART_CATALOGUE;
  options.diffusivity = request.diffusivity;
  drawing_stopped(hfrac_viz_render_charts(request.folder.c_str(), &options, nullptr, nullptr));
}
#endif

ExitCode catalogue(const CatalogueRequest& request) {
  const std::filesystem::path folder = request.folder;
  if (std::error_code error; !std::filesystem::is_regular_file(folder / "cracks.csv", error))
    throw BadInput(fmt::format("'{}' is not a run folder: it has no cracks.csv", request.folder));
  std::vector<hfrac_crack> cracks;
  std::vector<hfrac_slip> slips;
  try {
    cracks = output::read_crack_table(folder / "cracks.csv");
    if (std::error_code error; std::filesystem::is_regular_file(folder / "slips.csv", error))
      slips = output::read_slip_table(folder / "slips.csv");
  } catch (const output::FileError& error) {
    throw BadInput(error.what());
  }
  auto options = output::sized<hfrac_catalogue_options>();
  options.distance = request.distance;
  options.time_window = request.time_window;
  options.cycle_window = request.cycle_window;
  options.thickness = request.thickness;
  options.shear_modulus = request.shear_modulus;
  options.slip_rate = request.slip_rate;
  const auto events = output::events_of(cracks, slips, &options);
  output::write_whole(folder / "events.csv", output::event_table(events));
  if (!request.quakeml.empty()) write_quakeml(request, events);
#ifdef HFRAC_WITH_RENDERER
  if (!events.empty()) draw(request);
#endif
  if (!request.quiet) say(request, events, cracks.size(), slips.size());
  return kGood;
}

void add_quakeml_options(CLI::App& command, CatalogueRequest& request) {
  auto* file = command.add_option("--quakeml", request.quakeml, "QuakeML 1.2 file of the events");
  command.add_option("--start", request.start, "Date in UTC of the model's time 0")
      ->needs(file)
      ->capture_default_str();
  command.add_option("--latitude", request.earth.latitude, "Degrees north, of the model's (0, 0)")
      ->needs(file)
      ->check(CLI::Range(-89.0, 89.0))
      ->capture_default_str();
  command.add_option("--longitude", request.earth.longitude, "Degrees east")
      ->needs(file)
      ->check(CLI::Range(-180.0, 180.0))
      ->capture_default_str();
  command.add_option("--depth", request.earth.depth, "Metres, of the model's plane")
      ->needs(file)
      ->check(CLI::Range(-1e4, 1e6))
      ->capture_default_str();
  command.add_option("--azimuth", request.earth.azimuth, "Degrees of its x axis, from north clockwise")
      ->needs(file)
      ->check(CLI::Range(-360.0, 360.0))
      ->capture_default_str();
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
                   "Metres between cracks (slips) of one event; 0: two mean disc distances")
      ->check(positive);
  command->add_option("--seconds", request->time_window, "Seconds between them; 0: the same step (increment)")
      ->check(positive);
  command->add_option("--cycles", request->cycle_window, "Mechanical cycles between them; 0: any number")
      ->check(CLI::Range(int64_t{0}, int64_t{1000000000000}));
  command->add_option("--thickness", request->thickness, "Metres of rock that the plane stands for")
      ->check(CLI::Range(1e-9, 1e9))
      ->capture_default_str();
  command
      ->add_option("--shear-modulus", request->shear_modulus,
                   "Pascals, for the moments of slips; 0: as estimated from the model's bonds")
      ->check(positive);
  command
      ->add_option("--slip-rate", request->slip_rate,
                   "Metres per second: slips slower than that over their increment are left out")
      ->check(positive);
  command
      ->add_option("--completeness", request->completeness,
                   "Magnitude from which on b is found; left out: the fullest tenth")
      ->check(CLI::Range(-20.0, 20.0));
  add_quakeml_options(*command, *request);
#ifdef HFRAC_WITH_RENDERER
  command
      ->add_option("--diffusivity", request->diffusivity,
                   "Square metres per second of the envelope; 0: of that around 95 % of the events")
      ->check(positive);
  add_paper_options(*command, request->paper);
  add_format_options(*command, request->paper);
#endif
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  command->callback([request, &action] { action = [request] { return catalogue(*request); }; });
}

}  // namespace hfrac::command
