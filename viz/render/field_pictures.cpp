// SPDX-License-Identifier: BSD-3-Clause
// Pictures of quantities: fluid pressure in the domains, apertures of the cracks; and what every scene is
// loaded from.
#include <algorithm>
#include <cmath>

#include "disc_detail.h"
#include "failure.h"
#include "layers.h"
#include "number_text.h"
#include "pictures.h"
#include "sheet.h"

namespace hfrac::viz {
namespace {

// In the column: a colour bar below its label of `head` [unit], and a legend at the foot.
void draw_scale(Sheet& sheet, const ColourMap& map, double lowest, double highest, const std::string& label,
                const std::string& second_label, double head, const std::vector<LegendEntry>& entries) {
  const double unit = sheet.unit;
  const double legend_height = 44 * unit * static_cast<double>(entries.size());
  const double top = sheet.column_top + head * unit;
  const double room = sheet.column_bottom - top - legend_height - 60 * unit;
  draw_colour_bar(sheet.page, unit,
                  {sheet.column_left, top, 44 * unit, std::clamp(room, 80 * unit, 900 * unit)}, map, lowest,
                  highest, label, second_label);
  draw_legend(sheet.page, unit, sheet.column_left, sheet.column_bottom - legend_height, entries);
}

}  // namespace
std::string moment_text(const HistoryPoint& point) {
  std::string text = "t = " + time_text(point.moment.time);
  if (point.moment.step >= 0) text = "step " + count_text(point.moment.step) + ", " + text;
  return text;
}

Scene load_scene(const RunFolder& run, const HistoryPoint& point, bool with_bonds, bool with_flow) {
  Scene scene;
  scene.point = point;
  scene.discs = read_discs(run.discs.at(point.number));
  if (const SeriesFile* file = file_of(run.cracks, point.number)) scene.cracks = read_cracks(*file);
  if (with_bonds) {
    if (const SeriesFile* file = file_of(run.bonds, point.number)) scene.bonds = read_bonds(*file);
  }
  if (with_flow) {
    if (const SeriesFile* file = file_of(run.flow, point.number)) scene.flow = read_flow(*file);
  }
  return scene;
}

void pressure_picture(const Studio& studio, const Scene& scene, const PageSink& sink) {
  if (scene.flow.domains.empty())
    fail_reading("snapshot " + std::to_string(scene.point.number) + " has no flow data");
  Sheet sheet(studio, whole_model(*studio.run, scene.discs));
  const auto [low, high] =
      std::minmax_element(scene.flow.domains.begin(), scene.flow.domains.end(),
                          [](const Domain& a, const Domain& b) { return a.pressure < b.pressure; });
  const double lowest = low->pressure;
  const double highest = high->pressure > lowest ? high->pressure : lowest + pascal_per_megapascal;
  sheet.view.renderer->AddActor(domain_layer(scene.flow, bounds_of(sheet.view.extent), lowest, highest));
  if (!scene.cracks.cracks.empty()) {
    sheet.view.renderer->AddActor(crack_layer(scene.cracks.cracks, sheet.metres(1.5), sheet.metres(1.1)));
  }
  sheet.view.renderer->AddActor(well_rings(scene.flow, studio.run->wells, sheet.metres(1.6), palette().well));
  draw_sheet_title(sheet, *studio.run, "Fluid pressure: " + moment_text(scene.point));
  draw_axes(sheet.page, sheet.unit, sheet.view);
  draw_scale(sheet, pressure_map, lowest / pascal_per_megapascal, highest / pascal_per_megapascal,
             "fluid pressure (MPa)", studio.run->net_pressures ? "above the formation's" : "", 76,
             {{Sign::band, palette().tension, {}, "crack, tension"},
              {Sign::band, palette().shear, {}, "crack, shear"},
              {Sign::line, palette().well, {}, "wellbore"}});
  sink(sheet.page);
}

void aperture_picture(const Studio& studio, const Scene& scene, const PageSink& sink) {
  Sheet sheet(studio, around_cracks(*studio.run, scene));
  double widest = 0;
  for (const Crack& crack : scene.cracks.cracks) widest = std::max(widest, crack.aperture);
  const double radius = mean_radius(scene.discs);
  sheet.view.renderer->AddActor(well_layer(scene.flow, studio.run->wells, 2 * sheet.view.metres_per_pixel));
  sheet.view.renderer->AddActor(discs_in_view(sheet.view, scene.discs, palette().quiet_disc,
                                              palette().quiet_disc_rim, sheet.drawn_pixel()));
  if (!scene.cracks.cracks.empty()) {
    const double half_width = std::clamp(0.35 * radius, sheet.metres(5), sheet.metres(12));
    sheet.view.renderer->AddActor(aperture_layer(scene.cracks.cracks, widest, half_width));
  }
  draw_sheet_title(sheet, *studio.run,
                   "Crack aperture: " + moment_text(scene.point) + ", " +
                       counted(scene.point.cracks(), "crack") +
                       (widest > 0 ? ", widest " + value_text(widest * millimetres_per_metre) + " mm" : ""));
  draw_axes(sheet.page, sheet.unit, sheet.view);
  draw_scale(sheet, *palette().narrow, 0, widest > 0 ? widest * millimetres_per_metre : 1.0, "aperture (mm)",
             "", 46,
             {{Sign::disc, palette().quiet_disc, palette().quiet_disc_rim, "disc"},
              {Sign::hole, palette().well, {}, "wellbore"}});
  sink(sheet.page);
}

}  // namespace hfrac::viz
