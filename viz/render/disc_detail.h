// SPDX-License-Identifier: BSD-3-Clause
// How finely discs are drawn: as round points with a rim where they can be told apart, as density where not.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <span>
#include <vector>

#include "colour.h"
#include "page.h"
#include "snapshot.h"

namespace hfrac::viz {

// Discs that are smaller than a pixel or two, as density: every pixel gets as much of the discs' colours as discs
// cover of it. Round points would leave holes and moire patterns there, and take ten times as long.

// Red, green, blue; rows from the bottom up.
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

// On the palette's paper. `fills` has one colour for all, or one per disc. One pixel is one finished pixel of the view.
Raster disc_raster(const Discs& discs, std::span<const Colour> fills, const Extent& extent, int width,
                   int height);

// Whether the discs of this view are too small, or too many, for points.
bool drawn_as_density(const View& view, const Discs& discs);

// The discs of a view, all in one colour. `drawn_pixel` [m]: of a drawn pixel.
vtkSmartPointer<vtkActor> discs_in_view(const View& view, const Discs& discs, Colour fill, Colour rim,
                                        double drawn_pixel);
// Each disc in its own colour.
vtkSmartPointer<vtkActor> discs_in_view(const View& view, const Discs& discs, std::span<const Colour> fills,
                                        double drawn_pixel);

}  // namespace hfrac::viz
