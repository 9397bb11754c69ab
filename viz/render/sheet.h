// SPDX-License-Identifier: BSD-3-Clause
// The layout all single pictures share: title lines at the top, one framed view with axes, a column at its
// right.
#pragma once

#include <string>

#include "annotations.h"
#include "page.h"
#include "pictures.h"

namespace hfrac::viz {

// The whole model with a narrow margin, so that discs at its edge are seen whole.
Extent whole_model(const RunFolder& run, const Discs& discs);

// The cracks and the wells with room around them, inside the model.
Extent around_cracks(const RunFolder& run, const Scene& scene);

// Mean disc radius [m], 0 without discs.
double mean_radius(const Discs& discs);

struct SheetShape {
  double design_width = 1600;  // the width at which the unit is one pixel
  double column = 300;         // [unit] width of the column
  double needs = 640;          // [unit] height below which everything gets smaller
  // Whether the column takes all the width the view leaves; otherwise both stand in the middle.
  bool wide_column = false;
};

// Height of a sheet's page: the one asked for, or as the model's shape asks.
int sheet_height(const Studio& studio, const Extent& extent, const SheetShape& shape = {});

struct Sheet {
  Page page;
  View view;
  double unit;         // see annotations.h
  double column_left;  // [pixel] of the column at the right
  double column_width;
  double column_top;
  double column_bottom;

  Sheet(const Studio& studio, const Extent& extent, const SheetShape& shape = {});

  // The size of a drawn (not finished) pixel in the view [m].
  double drawn_pixel() const { return view.metres_per_pixel / page.drawn_pixels(); }
  // A length of `pixels` design pixels in the view [m].
  double metres(double pixels) const { return pixels * unit * view.metres_per_pixel; }
};

// The title of the run, or what the picture shows if the run has none; then the other line.
void draw_sheet_title(Sheet& sheet, const RunFolder& run, const std::string& what);

}  // namespace hfrac::viz
