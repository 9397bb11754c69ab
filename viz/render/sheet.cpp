// SPDX-License-Identifier: BSD-3-Clause
#include "sheet.h"

#include <algorithm>
#include <cmath>

namespace hfrac::viz {
namespace {

constexpr double margin_left = 112;  // all in units, see furniture.h
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
    double left = 0;
    double right = 1;
    double bottom = 0;
    double top = 1;
    bool first = true;
    for (const Disc& disc : discs.discs) {
      left = first ? disc.centre.x - disc.radius : std::min(left, disc.centre.x - disc.radius);
      right = first ? disc.centre.x + disc.radius : std::max(right, disc.centre.x + disc.radius);
      bottom = first ? disc.centre.y - disc.radius : std::min(bottom, disc.centre.y - disc.radius);
      top = first ? disc.centre.y + disc.radius : std::max(top, disc.centre.y + disc.radius);
      first = false;
    }
    extent = {left, bottom, std::max(right - left, 1e-9), std::max(top - bottom, 1e-9)};
  }
  const double margin = 0.012 * std::max(extent.width, extent.height);
  return {extent.left - margin, extent.bottom - margin, extent.width + 2 * margin,
          extent.height + 2 * margin};
}

Extent around_cracks(const RunFolder& run, const Scene& scene) {
  const Extent model = whole_model(run, scene.discs);
  if (scene.cracks.cracks.empty()) return model;
  double left = INFINITY;
  double right = -INFINITY;
  double bottom = INFINITY;
  double top = -INFINITY;
  const auto include = [&](double x, double y, double radius) {
    left = std::min(left, x - radius);
    right = std::max(right, x + radius);
    bottom = std::min(bottom, y - radius);
    top = std::max(top, y + radius);
  };
  for (const Crack& crack : scene.cracks.cracks) {
    include(crack.line.from.x, crack.line.from.y, 0);
    include(crack.line.to.x, crack.line.to.y, 0);
  }
  for (const WellPlace& well : run.wells) include(well.x, well.y, well.radius);
  const double radius = mean_radius(scene.discs);
  const double size = std::max({right - left, top - bottom, 20 * radius});
  // Never flatter than 3 to 4, so that a straight fracture does not make a strip of a picture.
  const double width = std::min(model.width, std::max(1.16 * (right - left), 0.9 * size));
  const double height = std::min(model.height, std::max(1.16 * (top - bottom), 0.7 * size));
  const double x = std::clamp((left + right - width) / 2, model.left, model.left + model.width - width);
  const double y =
      std::clamp((bottom + top - height) / 2, model.bottom, model.bottom + model.height - height);
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
