// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the discs, their bonds and the cracks: the model, the stages of growth, the page of stages.
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

std::vector<LegendEntry> growth_legend(bool bonds) {
  std::vector<LegendEntry> entries = {{Sign::disc, palette().disc, palette().disc_rim, "disc"}};
  if (bonds) entries.push_back({Sign::line, palette().bond, {}, "intact bond"});
  entries.push_back({Sign::band, palette().tension, {}, "crack, tension"});
  entries.push_back({Sign::band, palette().shear, {}, "crack, shear"});
  entries.push_back({Sign::hole, palette().well, {}, "wellbore"});
  return entries;
}

// Bold at the scale of the whole model, not wider than the discs close up.
double crack_half_width(double pixel_metres, double radius) {
  return std::clamp(0.2 * radius, 2.2 * pixel_metres, 5.0 * pixel_metres);
}

// [pixel] A hair on discs of two pixels, where lines would hide the discs, one on discs of five.
double bond_width(double radius_pixels) {
  return std::clamp(0.25 * radius_pixels - 0.3, 0.1, 2.0);
}

std::string megapascal_text(double pascal) {
  return value_text(std::round(pascal / pascal_per_megapascal * 100) / 100) + " MPa";
}

std::vector<Note> moment_notes(const RunFolder& run, const HistoryPoint& point) {
  std::vector<Note> notes = {{"time", time_text(point.moment.time)}};
  if (point.moment.step >= 0) notes.push_back({"step", count_text(point.moment.step)});
  const std::string net = run.net_pressures ? ", net" : "";
  const std::size_t wells = std::min<std::size_t>(point.moment.well_pressure.size(), 2);
  for (std::size_t i = 0; i < wells; ++i) {
    std::string name = "well pressure";
    if (wells > 1) name.append(" ").append(std::to_string(i + 1));
    notes.push_back({name + net, megapascal_text(point.moment.well_pressure[i])});
  }
  notes.push_back({"cracks", count_text(point.cracks())});
  notes.push_back(
      {"in tension / in shear", count_text(point.tensile_cracks) + " / " + count_text(point.shear_cracks)});
  return notes;
}

// Where the stages are on the page of stages: three beside each other, two if the model is much wider than
// high; the last place is the legend's.
struct GrowthGrid {
  int columns;
  int rows;
  double unit;
  double margin;
  double top;
  double gap;
  double caption;
  double cell_width;
  double cell_height;
  int page_height;  // [pixel]

  GrowthGrid(const Studio& studio, const Extent& extent)
      : columns(extent.height < 0.55 * extent.width ? 2 : 3),
        rows(columns == 2 ? 3 : 2),
        unit(studio.size.width / 1600.0),
        margin(40 * unit),
        top(124 * unit),
        gap(30 * unit),
        caption(64 * unit),
        cell_width((studio.size.width - 2 * margin - (columns - 1) * gap) / columns),
        cell_height(std::min(cell_width * extent.height / extent.width, 3 * cell_width)),
        page_height(studio.size.height) {
    const double legend_height = 400 * unit;
    const double last_row = std::max(cell_height + caption, legend_height);
    if (page_height <= 0) {
      page_height =
          static_cast<int>(std::ceil(top + (rows - 1) * (cell_height + caption) + last_row + 10 * unit));
      page_height = std::clamp(page_height, 240, 8192);
    }
    const double room = page_height - top - 10 * unit;
    cell_height = std::max(
        16.0, std::min({cell_height, (room - legend_height) / (rows - 1) - caption, room / rows - caption}));
  }
  Box cell(int index) const {
    const int row = index / columns;
    const int column = index % columns;
    return {margin + column * (cell_width + gap), top + row * (cell_height + caption), cell_width,
            cell_height};
  }
};

}  // namespace

void add_growth_layers(const View& view, const Page& page, const RunFolder& run, const Scene& scene,
                       double unit_metres) {
  const double radius = mean_radius(scene.discs);
  view.renderer->AddActor(well_layer(scene.flow, run.wells, 2 * view.metres_per_pixel));
  const Colour rim = scene.bonds.intact.empty() ? palette().disc_rim : palette().soft_disc_rim;
  view.renderer->AddActor(
      discs_in_view(view, scene.discs, palette().disc, rim, view.metres_per_pixel / page.drawn_pixels()));
  if (!scene.bonds.intact.empty() && !drawn_as_density(view, scene.discs)) {
    const double width = bond_width(radius / view.metres_per_pixel) * page.drawn_pixels();
    view.renderer->AddActor(bond_layer(scene.bonds.intact, bounds_of(view.extent), palette().bond, width));
  }
  if (!scene.cracks.cracks.empty()) {
    view.renderer->AddActor(crack_layer(scene.cracks.cracks, crack_half_width(unit_metres, radius), 0.0));
  }
}

void model_picture(const Studio& studio, const Scene& scene, const PageSink& sink) {
  Sheet sheet(studio, whole_model(*studio.run, scene.discs));
  const double radius_pixels = mean_radius(scene.discs) / sheet.view.metres_per_pixel;
  sheet.view.renderer->AddActor(well_layer(scene.flow, studio.run->wells, 2 * sheet.view.metres_per_pixel));
  sheet.view.renderer->AddActor(
      discs_in_view(sheet.view, scene.discs, palette().disc, palette().soft_disc_rim, sheet.drawn_pixel()));
  if (!scene.bonds.intact.empty() && !drawn_as_density(sheet.view, scene.discs)) {
    const double width = bond_width(radius_pixels) * sheet.page.drawn_pixels();
    sheet.view.renderer->AddActor(
        bond_layer(scene.bonds.intact, bounds_of(sheet.view.extent), palette().ink, width));
  }
  const auto disc_count = static_cast<std::int64_t>(scene.discs.discs.size());
  const auto bond_count = static_cast<std::int64_t>(scene.bonds.intact.size());
  draw_sheet_title(sheet, *studio.run,
                   "Particle model: " + counted(disc_count, "disc") +
                       (bond_count > 0 ? ", " + counted(bond_count, "bonded contact") : ""));
  draw_axes(sheet.page, sheet.unit, sheet.view);
  std::vector<LegendEntry> entries = {{Sign::disc, palette().disc, palette().disc_rim, "disc"}};
  if (bond_count > 0) entries.push_back({Sign::line, palette().ink, {}, "bonded contact"});
  entries.push_back({Sign::hole, palette().well, {}, "wellbore"});
  const double below = draw_legend(sheet.page, sheet.unit, sheet.column_left, sheet.column_top, entries);
  draw_scale_bar(sheet.page, sheet.unit, sheet.column_left, below + 50 * sheet.unit, 0.8 * sheet.column_width,
                 sheet.view.metres_per_pixel);
  sink(sheet.page);
}

void stage_picture(const Studio& studio, const Scene& scene, const PageSink& sink) {
  constexpr double column_needs = 980;  // legend, scale bar and notes below each other
  Sheet sheet(studio, whole_model(*studio.run, scene.discs), {1600, 300, column_needs, false});
  add_growth_layers(sheet.view, sheet.page, *studio.run, scene, sheet.metres(1));
  draw_sheet_title(
      sheet, *studio.run,
      "Fracture growth: " + moment_text(scene.point) + ", " + counted(scene.point.cracks(), "crack"));
  draw_axes(sheet.page, sheet.unit, sheet.view);
  double below = draw_legend(sheet.page, sheet.unit, sheet.column_left, sheet.column_top,
                             growth_legend(!scene.bonds.intact.empty()));
  below = draw_scale_bar(sheet.page, sheet.unit, sheet.column_left, below + 40 * sheet.unit,
                         0.8 * sheet.column_width, sheet.view.metres_per_pixel);
  draw_notes(sheet.page, sheet.unit, sheet.column_left, below + 40 * sheet.unit,
             moment_notes(*studio.run, scene.point));
  sink(sheet.page);
}

void growth_picture(const Studio& studio, const SceneList& scenes, const PageSink& sink) {
  if (scenes.count == 0) fail_reading("the run has no snapshots");
  auto scene = scenes.load(0);
  const Extent extent = whole_model(*studio.run, scene->discs);
  const GrowthGrid grid(studio, extent);
  const double unit = grid.unit;
  Page page(studio.window, studio.size.width, grid.page_height);
  const std::string what = "Fracture growth";
  const bool untitled = studio.run->title.empty();
  draw_title(page, unit, grid.margin, untitled ? what : studio.run->title, untitled ? "" : what);
  double metres_per_pixel = 1;
  bool bonds = false;
  for (int i = 0; i < scenes.count && i < grid.columns * grid.rows - 1; ++i) {
    if (i > 0) {
      scene.reset();
      scene = scenes.load(i);
    }
    const View view = page.view(grid.cell(i), extent);
    const HistoryPoint& point = scene->point;
    metres_per_pixel = view.metres_per_pixel;
    bonds = bonds || !scene->bonds.intact.empty();
    add_growth_layers(view, page, *studio.run, *scene, 0.8 * unit * view.metres_per_pixel);
    draw_frame(page, unit, view);
    std::string caption = "(a) ";
    caption[1] = static_cast<char>('a' + i);
    caption += moment_text(point) + ", " + counted(point.cracks(), "crack");
    const TextStyle style{24 * unit, palette().ink};
    page.text(view.box.left, view.box.bottom() + 34 * unit, fitted(page, caption, style, grid.cell_width),
              style);
  }
  const Box last = grid.cell(grid.columns * grid.rows - 1);
  const double left = last.left + 20 * unit;
  const double below = draw_legend(page, unit, left, last.top, growth_legend(bonds));
  draw_scale_bar(page, unit, left, below + 40 * unit, 0.5 * last.width, metres_per_pixel);
  sink(page);
}

}  // namespace hfrac::viz
