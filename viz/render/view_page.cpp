// SPDX-License-Identifier: BSD-3-Clause
#include "view_page.h"

#include <algorithm>
#include <cmath>

#include "failure.h"
#include "number_text.h"
#include "page.h"
#include "pictures.h"
#include "run/files.hpp"
#include "sheet.h"
#include "view_layers.h"
#include "vtk_messages.h"

namespace hfrac::viz {
namespace {

// A square around a place, pushed back into the model.
Extent square_around(const Extent& model, Point centre, double side) {
  const double width = std::min(side, model.width);
  const double height = std::min(side, model.height);
  return {std::clamp(centre.x - width / 2, model.left, model.left + model.width - width),
          std::clamp(centre.y - height / 2, model.bottom, model.bottom + model.height - height), width,
          height};
}

double distance_to_wells(const RunFolder& run, Point place) {
  double nearest = INFINITY;
  for (const WellPlace& well : run.wells)
    nearest = std::min(nearest, std::hypot(place.x - well.x, place.y - well.y));
  return std::isfinite(nearest) ? nearest
                                : std::hypot(place.x - run.model_width / 2, place.y - run.model_height / 2);
}

Extent on_the_well(const RunFolder& run, const Scene& scene, const Extent& model) {
  if (run.wells.empty()) fail_argument("the run has no well to look at");
  const WellPlace& well = run.wells.front();
  const double side = std::max(4 * well.radius, 24 * mean_radius(scene.discs));
  return square_around(model, {well.x, well.y}, side);
}

Extent on_the_tip(const RunFolder& run, const Scene& scene, const Extent& model) {
  if (scene.cracks.cracks.empty()) return on_the_well(run, scene, model);
  Point tip = scene.cracks.cracks.front().line.from;
  for (const Crack& crack : scene.cracks.cracks) {
    for (const Point& end : {crack.line.from, crack.line.to}) {
      if (distance_to_wells(run, end) > distance_to_wells(run, tip)) tip = end;
    }
  }
  return square_around(model, tip, 30 * mean_radius(scene.discs));
}

// The scale, and beside it the signs, in a column at a view's right.
void draw_key(Page& page, double unit, const Box& column, const Key& key) {
  double top = column.top;
  if (!key.entries.empty()) top = draw_legend(page, unit, column.left, top, key.entries);
  if (key.map == nullptr) {
    page.text(column.left, top + 34 * unit, key.label, {22 * unit, palette().ink});
    return;
  }
  const double head = (key.second_label.empty() ? 46 : 76) * unit;
  const Box bar{column.left, top + head, 40 * unit, std::min(620 * unit, column.bottom() - top - head)};
  draw_colour_bar(page, unit, bar, *key.map, key.lowest, key.highest, key.label, key.second_label);
}

void single(const Studio& studio, const Scene& scene, const ViewSpec& spec, const Extent& extent,
            const PageSink& sink) {
  Sheet sheet(studio, extent);
  const Key key =
      add_view_layers(sheet.view, *studio.run, scene, spec, {sheet.metres(1), sheet.drawn_pixel()});
  draw_sheet_title(sheet, *studio.run, key.title + ": " + moment_text(scene.point));
  draw_axes(sheet.page, sheet.unit, sheet.view);
  const double bar_top = sheet.column_bottom - 70 * sheet.unit;
  draw_key(
      sheet.page, sheet.unit,
      {sheet.column_left, sheet.column_top, sheet.column_width, bar_top - 40 * sheet.unit - sheet.column_top},
      key);
  draw_scale_bar(sheet.page, sheet.unit, sheet.column_left, bar_top, 0.8 * sheet.column_width,
                 sheet.view.metres_per_pixel);
  sink(sheet.page);
}

// Where the views of a page are.
struct Places {
  int columns;
  int rows;
  double unit;
  double cell_width;
  double cell_height;
  int page_height;

  static constexpr double margin = 40;
  static constexpr double top = 124;
  static constexpr double gap = 36;
  static constexpr double caption = 54;
  static constexpr double key_width = 250;

  Places(const Studio& studio, int count, const Extent& extent)
      : columns(count <= 3             ? count
                : (count + 1) / 2 <= 3 ? (count + 1) / 2
                                       : 3),
        rows((count + columns - 1) / columns),
        unit(studio.size.width / (columns <= 2 ? 1700.0 : 2400.0)),
        cell_width((studio.size.width - (2 * margin + (columns - 1) * gap) * unit) / columns),
        cell_height(std::clamp((cell_width - key_width * unit) * extent.height / extent.width, 420 * unit,
                               3 * cell_width)),
        page_height(studio.size.height) {
    const double around = (top + 20) * unit + rows * caption * unit;
    if (page_height <= 0) {
      page_height = std::clamp(static_cast<int>(std::ceil(around + rows * cell_height)), 240, 8192);
    }
    cell_height = std::max(16.0, (page_height - around) / rows);
  }
  Box cell(int index) const {
    const int row = index / columns, column = index % columns;
    return {(margin + column * gap) * unit + column * cell_width,
            (top + caption - 14) * unit + row * (cell_height + caption * unit), cell_width, cell_height};
  }
};

void views_on_page(const Studio& studio, const Scene& scene, const std::vector<ViewSpec>& specs,
                   const Extent& extent, const PageSink& sink) {
  if (specs.size() == 1) {
    single(studio, scene, specs.front(), extent, sink);
    return;
  }
  const Places layout(studio, static_cast<int>(specs.size()), extent);
  const double unit = layout.unit;
  Page page(studio.window, studio.size.width, layout.page_height);
  const std::string title = studio.run->title;
  draw_title(page, unit, Places::margin * unit, title.empty() ? moment_text(scene.point) : title,
             title.empty() ? "" : moment_text(scene.point));
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const Box cell = layout.cell(static_cast<int>(i));
    const View view =
        page.view({cell.left, cell.top, cell.width - Places::key_width * unit, cell.height}, extent);
    const Key key =
        add_view_layers(view, *studio.run, scene, specs[i],
                        {0.8 * unit * view.metres_per_pixel, view.metres_per_pixel / page.drawn_pixels()});
    draw_frame(page, unit, view);
    page.text(cell.left, cell.top - 12 * unit, key.title, {25 * unit, palette().ink, true});
    const double left = view.box.right() + 22 * unit;
    const double bar_top = view.box.bottom() - 62 * unit;
    draw_key(page, 0.88 * unit, {left, cell.top, Places::key_width * unit, bar_top - 24 * unit - cell.top},
             key);
    draw_scale_bar(page, 0.88 * unit, left, bar_top, 0.7 * Places::key_width * unit, view.metres_per_pixel);
  }
  sink(page);
}

// The part of the model that is asked for.
Extent zoomed(const RunFolder& run, const Scene& scene, const hfrac_viz_view_options& options) {
  const Extent model = whole_model(run, scene.discs);
  switch (options.zoom) {
    case HFRAC_VIZ_ZOOM_CRACKS:
      return around_cracks(run, scene);
    case HFRAC_VIZ_ZOOM_WELL:
      return on_the_well(run, scene, model);
    case HFRAC_VIZ_ZOOM_TIP:
      return on_the_tip(run, scene, model);
    case HFRAC_VIZ_ZOOM_BOX:
      return {options.left, options.bottom, options.box_width, options.box_height};
    default:
      return model;
  }
}

}  // namespace

void render_views(const RunFolder& run, const std::vector<ViewSpec>& specs,
                  const std::filesystem::path& target, const hfrac_viz_view_options& options) {
  const std::string ending = picture_ending(target);
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  const auto window = make_offscreen_window();
  const Scene scene = load_scene(run, history_point(run, options.snapshot), false, true);
  const Studio studio{window, &run, {options.width, options.height}};
  const Extent extent = zoomed(run, scene, options);
  const std::string title = run.title.empty() ? "hfrac" : run.title;
  VtkMessages messages;
  std::vector<std::uint8_t> content;
  views_on_page(studio, scene, specs, extent,
                [&](Page& page) { content = page_content(page, ending, title, options.dots_per_inch); });
  messages.demand_none();
  write_whole(target, content);
}

}  // namespace hfrac::viz
