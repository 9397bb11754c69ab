// SPDX-License-Identifier: BSD-3-Clause
// A page as SVG: discs as circles, bands and domains as paths, letters as text, so that it prints sharp at any size and
// can be edited. What is on the page is read back from VTK's actors; nothing is drawn twice by hand.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "page.h"

namespace hfrac::viz {

struct PageDrawing {
  int width = 0;   // [pixel]
  int height = 0;  // [pixel]
  int factor = 1;  // drawn pixels per pixel: line widths and the overlay's places are in drawn ones
  std::string title;
  std::span<const View> views;
  vtkSmartPointer<vtkActor> overlay;  // may be none
  std::span<const PageText> texts;
};

std::string page_svg(const PageDrawing& drawing);

}  // namespace hfrac::viz
