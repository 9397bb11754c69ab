// SPDX-License-Identifier: BSD-3-Clause
#include "sheet.h"

#include <algorithm>
#include <cmath>

#include "snapshot.h"

namespace hfrac::viz {
namespace {

constexpr double margin_left = 112;  // all in units, see annotations.h
constexpr double margin_top = 124;
constexpr double margin_bottom = 86;
constexpr double column_gap = 36;
constexpr double right_margin = 24;
constexpr int smallest_height = 240;  // [pixel]
constexpr int largest_height = 8192;

double unit_of(const Studio& studio, const SheetShape& shape) {
  return studio.size.width / shape.design_width;
}

double view_width(const Studio& studio, const SheetShape& shape, double unit) {
  return studio.size.width - unit * (margin_left + column_gap + shape.column);
}

int even(double height) {
  return static_cast<int>(std::ceil(height / 2)) * 2;
}

// Where the view goes: the largest that fits, in the middle of the room it has.
Box room_of(const Studio& studio, const Page& page, const Extent& extent, const SheetShape& shape,
            double unit) {
  Box room{margin_left * unit, margin_top * unit, std::max(16.0, view_width(studio, shape, unit)),
           std::max(16.0, page.height() - unit * (margin_top + margin_bottom))};
  const double metres_per_pixel = std::max(extent.width / room.width, extent.height / room.height);
  room.top += std::max(0.0, room.height - extent.height / metres_per_pixel) / 2;
  if (!shape.wide_column) room.left += std::max(0.0, room.width - extent.width / metres_per_pixel) / 2;
  return room;
}

}  // namespace

Extent whole_model(const RunFolder& run, const Discs& discs) {
  Extent extent{0, 0, run.model_width, run.model_height};
  if (!(run.model_width > 0) || !(run.model_height > 0)) {
    Bounds bounds;
    for (const Disc& disc : discs.discs) bounds.include(disc.centre, disc.radius);
    if (bounds.empty()) bounds = {0, 1, 0, 1};
    extent = {bounds.left, bounds.bottom, std::max(bounds.width(), 1e-9), std::max(bounds.height(), 1e-9)};
  }
  const double margin = 0.012 * std::max(extent.width, extent.height);
  return {extent.left - margin, extent.bottom - margin, extent.width + 2 * margin,
          extent.height + 2 * margin};
}

Extent around_cracks(const RunFolder& run, const Scene& scene) {
  const Extent model = whole_model(run, scene.discs);
  if (scene.cracks.cracks.empty()) return model;
  Bounds bounds;
  for (const Crack& crack : scene.cracks.cracks) {
    bounds.include(crack.line.from);
    bounds.include(crack.line.to);
  }
  for (const WellPlace& well : run.wells) bounds.include({well.x, well.y}, well.radius);
  const double size = std::max({bounds.width(), bounds.height(), 20 * mean_radius(scene.discs)});
  // Never flatter than 3 to 4, so that a straight fracture does not make a strip of a picture.
  const double width = std::min(model.width, std::max(1.16 * bounds.width(), 0.9 * size));
  const double height = std::min(model.height, std::max(1.16 * bounds.height(), 0.7 * size));
  const Point middle = bounds.middle();
  const double x = std::clamp(middle.x - width / 2, model.left, model.left + model.width - width);
  const double y = std::clamp(middle.y - height / 2, model.bottom, model.bottom + model.height - height);
  return {x, y, width, height};
}

double mean_radius(const Discs& discs) {
  if (discs.discs.empty()) return 0;
  double sum = 0;
  for (const Disc& disc : discs.discs) sum += disc.radius;
  return sum / static_cast<double>(discs.discs.size());
}

int sheet_height(const Studio& studio, const Extent& extent, const SheetShape& shape) {
  if (studio.size.height > 0) return studio.size.height;
  const double unit = unit_of(studio, shape);
  const double view_height = view_width(studio, shape, unit) * extent.height / extent.width;
  const double column_needs = 700 * unit;
  return std::clamp(even(std::max(view_height, column_needs) + unit * (margin_top + margin_bottom)),
                    smallest_height,
                    std::min(largest_height, std::max(smallest_height, 3 * studio.size.width)));
}

Sheet::Sheet(const Studio& studio, const Extent& extent, const SheetShape& shape)
    : page(studio.window, studio.size.width, sheet_height(studio, extent, shape)),
      unit(std::min(unit_of(studio, shape), page.height() / shape.needs)),
      column_left(0),
      column_width(shape.column * unit),
      column_top(margin_top * unit),
      column_bottom(page.height() - margin_bottom * unit) {
  view = page.view(room_of(studio, page, extent, shape, unit), extent);
  column_left = view.box.right() + column_gap * unit;
  if (shape.wide_column) column_width = page.width() - column_left - right_margin * unit;
}

void draw_sheet_title(Sheet& sheet, const RunFolder& run, const std::string& what) {
  const bool untitled = run.title.empty();
  draw_title(sheet.page, sheet.unit, sheet.view.box.left, untitled ? what : run.title, untitled ? "" : what);
}

}  // namespace hfrac::viz
