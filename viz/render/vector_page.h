// SPDX-License-Identifier: BSD-3-Clause
// A page as vectors: discs as circles, bands and domains as paths, letters as text, so that it prints sharp at any size
// and can be edited. What is on the page is read back from VTK's actors; nothing is drawn twice by hand.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "page.h"

namespace hfrac::viz {

class VectorCanvas;

struct PageDrawing {
  const Page* page = nullptr;
  std::string title;
  std::span<const View> views;
  vtkSmartPointer<vtkActor> overlay;  // may be none
  std::span<const PageText> texts;
};

void draw_vectors(const PageDrawing& drawing, VectorCanvas& canvas);

std::string svg_page(const PageDrawing& drawing);
// dots_per_inch: how large it is on paper; 0: 96, as on the screen.
std::vector<std::uint8_t> pdf_page(const PageDrawing& drawing, int dots_per_inch);

}  // namespace hfrac::viz
