// SPDX-License-Identifier: BSD-3-Clause
// Charts of the crack log: where the cracks point, how wide they are along the fracture, how strong they
// broke.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "charts.h"
#include "rose.h"

namespace hfrac::viz {
namespace {

constexpr double pi = std::numbers::pi;

struct LoggedCrack {
  Point place;
  double azimuth = 0;  // [rad] in [0, pi), of the crack's line, counter-clockwise from x
  double length = 0;   // [m]
  double aperture = 0;
  double time = 0;
  double energy = 0;
  bool shear = false;
};

std::vector<LoggedCrack> logged_cracks(const TableFile& table) {
  const auto x = table.numbers("x_m");
  const auto y = table.numbers("y_m");
  const auto normal_x = table.numbers("normal_x");
  const auto normal_y = table.numbers("normal_y");
  const auto length = table.numbers("length_m");
  const auto aperture = table.numbers("aperture_m");
  const auto time = table.numbers("time_s");
  const auto energy = table.numbers("energy_J_per_m");
  const auto mode = table.words("mode");
  std::vector<LoggedCrack> cracks;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (!std::isfinite(x[i] + y[i] + normal_x[i] + normal_y[i] + length[i])) continue;
    double azimuth = std::fmod(std::atan2(normal_x[i], -normal_y[i]) + 2 * pi, pi);
    if (azimuth >= pi) azimuth = 0;
    cracks.push_back({{x[i], y[i]}, azimuth, length[i], aperture[i], time[i], energy[i], mode[i] == "shear"});
  }
  return cracks;
}

// The mean direction of the cracks, weighted by their lengths; lines have no sense, so angles are doubled.
double mean_azimuth(const std::vector<LoggedCrack>& cracks) {
  double x = 0;
  double y = 0;
  for (const LoggedCrack& crack : cracks) {
    x += crack.length * std::cos(2 * crack.azimuth);
    y += crack.length * std::sin(2 * crack.azimuth);
  }
  return std::atan2(y, x) / 2;
}

void put_names_right(ChartPage& page, double left, double top,
                     const std::vector<std::pair<Colour, std::string>>& names) {
  for (const auto& [colour, name] : names) {
    page.polygon({{left, top - 16}, {left + 26, top - 16}, {left + 26, top + 2}, {left, top + 2}}, colour);
    page.text(left + 40, top, name, {22, palette().ink});
    top += 40;
  }
}

// Where a crack is as seen from the nearest well, or from the model's middle where no well is known.
struct FromWell {
  double distance = 0;   // [m] from the well's wall
  double direction = 0;  // [rad] in [-pi, pi]
};

FromWell from_well(const LoggedCrack& crack, const RunFolder& run) {
  if (run.wells.empty()) {
    const double dx = crack.place.x - run.model_width / 2;
    const double dy = crack.place.y - run.model_height / 2;
    return {std::hypot(dx, dy), std::atan2(dy, dx)};
  }
  FromWell nearest{INFINITY, 0};
  for (const WellPlace& well : run.wells) {
    const double dx = crack.place.x - well.x;
    const double dy = crack.place.y - well.y;
    const double distance = std::hypot(dx, dy) - well.radius;
    if (distance < nearest.distance) nearest = {distance, std::atan2(dy, dx)};
  }
  return {std::max(0.0, nearest.distance), nearest.direction};
}

// Directions of the wings from the wells: those in which cracks lie beyond a fifth of the longest distance, parted where
// there are 40 degrees without one. Cracks nearer than that lie all around a well.
std::vector<double> wing_directions(const std::vector<FromWell>& places) {
  constexpr double near_well = 0.2;
  constexpr double gap = 40 * pi / 180;
  double farthest = 0;
  for (const FromWell& place : places) farthest = std::max(farthest, place.distance);
  std::vector<double> angles;
  for (const FromWell& place : places)
    if (place.distance > near_well * farthest) angles.push_back(place.direction);
  std::sort(angles.begin(), angles.end());
  if (angles.empty()) return {};
  // Around the circle from behind a gap, so that no wing is cut at +-pi.
  std::size_t first = 0;
  for (std::size_t i = 1; i < angles.size(); ++i)
    if (angles[i] - angles[i - 1] > gap) first = i;
  std::rotate(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(first), angles.end());
  std::vector<double> wings;
  double x = 0, y = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    x += std::cos(angles[i]);
    y += std::sin(angles[i]);
    const double next = i + 1 < angles.size() ? angles[i + 1] - angles[i] : 2 * pi;
    if (std::fmod(next + 2 * pi, 2 * pi) > gap || i + 1 == angles.size()) {
      wings.push_back(std::atan2(y, x));
      x = y = 0;
    }
  }
  return wings;
}

std::size_t nearest_wing(const std::vector<double>& wings, double direction) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < wings.size(); ++k)
    if (std::cos(direction - wings[k]) > std::cos(direction - wings[best])) best = k;
  return best;
}

// One bond that broke is one event. Its elastic energy is what it could radiate at most; the energy magnitude of
// Choy and Boatwright (1995), M = 2/3 log10(E / 1 J) - 2.9, is therefore an upper bound.
double magnitude_of(double energy) {
  return 2.0 / 3.0 * std::log10(energy) - 2.9;
}

}  // namespace

void fill_rose(ChartPage& page, const ChartData& data) {
  constexpr int bins = 18;
  constexpr double radius = 440;
  const Point centre{620, 660};
  const std::vector<LoggedCrack> cracks = logged_cracks(*data.cracks);
  RoseBins metres(bins, std::vector<double>(2, 0.0));
  for (const LoggedCrack& crack : cracks) {
    metres[std::min(bins - 1, static_cast<int>(crack.azimuth / pi * bins))][crack.shear ? 1 : 0] +=
        crack.length;
  }
  put_heading(page, *data.run, "Directions of " + counted(static_cast<std::int64_t>(cracks.size()), "crack"));
  const RoseScale scale = put_rose(page, centre, radius, metres, {palette().water, palette().shear});
  put_names_right(page, 1180, 280, {{palette().water, "in tension"}, {palette().shear, "in shear"}});
  const std::array<std::string, 4> lines = {
      "Length of cracks per 10\xC2\xB0,", "both ends of every crack shown.",
      "Rings every " + scale.ring + " m; longest " + value_text(scale.longest) + " m.",
      "0\xC2\xB0 is the x axis."};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    page.text(1180, 400 + 34 * static_cast<double>(i), lines[i], {20, palette().faint_ink});
  }
  if (cracks.empty()) return;
  const double mean = std::fmod(mean_azimuth(cracks) + pi, pi);
  page.text(1180, 400 + 34.0 * 5, "Mean direction " + value_text(mean * 180 / pi) + "\xC2\xB0",
            {24, palette().ink});
}

namespace {

// Cracks as dots of aperture over distance. With up to two wings on one axis, one of them negative; more have a panel each.
struct Profile {
  std::vector<double> wings;
  std::vector<Panel> panels;

  explicit Profile(const ChartData& data) {
    const std::vector<LoggedCrack> cracks = logged_cracks(*data.cracks);
    std::vector<FromWell> places;
    places.reserve(cracks.size());
    for (const LoggedCrack& crack : cracks) places.push_back(from_well(crack, *data.run));
    wings = wing_directions(places);
    const bool apart = wings.size() > 2;
    const double azimuth = mean_azimuth(cracks);
    for (std::size_t k = 0; k < (apart ? wings.size() : 1); ++k) {
      Panel panel{"Aperture", "distance from the wall of the well (m), one wing negative", {}, false, false};
      if (apart) {
        const auto degrees = static_cast<std::int64_t>(std::lround(wings[k] * 180 / pi + 360)) % 360;
        panel.title = "Aperture, wing at " + count_text(degrees) + "\xC2\xB0";
        panel.x_label = "distance from the wall of the well (m)";
      }
      panel.series = {{"crack in tension", "mm", palette().water, {}, {}},
                      {"crack in shear", "mm", palette().shear, {}, {}}};
      panels.push_back(std::move(panel));
    }
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      const FromWell& place = places[i];
      Panel& panel = panels[apart ? nearest_wing(wings, place.direction) : 0];
      ChartSeries& series = panel.series[cracks[i].shear ? 1 : 0];
      series.dots = true;
      series.x.push_back(!apart && std::cos(place.direction - azimuth) < 0 ? -place.distance
                                                                           : place.distance);
      series.y.push_back(cracks[i].aperture * millimetres_per_metre);
    }
    for (Panel& panel : panels)
      std::erase_if(panel.series, [](const ChartSeries& series) { return series.x.empty(); });
  }
};

constexpr double wing_height = 450;  // of a panel for a wing with what stands around it

}  // namespace

double profile_height(const ChartData& data) {
  const std::size_t panels = Profile(data).panels.size();
  const std::size_t rows = (panels + 1) / 2;
  return panels > 1 ? 130 + wing_height * static_cast<double>(rows) : 840;
}

void fill_profile(ChartPage& page, const ChartData& data) {
  const Profile profile(data);
  put_heading(page, *data.run, "Aperture along the fracture");
  if (profile.panels.size() == 1) return page.panel({130, 200, 1420, 520}, profile.panels.front());
  for (std::size_t k = 0; k < profile.panels.size(); ++k) {
    const std::size_t row = k / 2;
    page.panel({k % 2 == 0 ? 130.0 : 950.0, 220 + wing_height * static_cast<double>(row), 600, 260},
               profile.panels[k]);
  }
}

void fill_events(ChartPage& page, const ChartData& data) {
  std::vector<double> magnitudes;
  std::vector<ChartSeries> over_time = {{"in tension", "", palette().water, {}, {}},
                                        {"in shear", "", palette().shear, {}, {}}};
  for (const LoggedCrack& crack : logged_cracks(*data.cracks)) {
    if (!(crack.energy > 0)) continue;
    const double magnitude = magnitude_of(crack.energy);
    magnitudes.push_back(magnitude);
    ChartSeries& series = over_time[crack.shear ? 1 : 0];
    series.x.push_back(crack.time);
    series.y.push_back(magnitude);
  }
  put_heading(page, *data.run,
              "Energy magnitudes of " + counted(static_cast<std::int64_t>(magnitudes.size()), "crack"));
  page.text(96, 128,
            "M = 2/3 log10 E \xE2\x88\x92 2.9 (Choy and Boatwright 1995), E: elastic energy of the broken "
            "bond in J, at a thickness of 1 m. An upper bound.",
            {18, palette().faint_ink});
  page.panel({120, 250, 554, 420}, course_panel(std::move(over_time)));
  page.panel({926, 250, 554, 420}, frequency_panel("Cracks at least as strong", std::move(magnitudes)));
}

}  // namespace hfrac::viz
