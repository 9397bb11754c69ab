// SPDX-License-Identifier: BSD-3-Clause
// A page as vectors: discs as circles, bands and domains as paths, letters as text, so that it prints sharp at any size
// and can be edited. What is on the page is read back from VTK's actors; nothing is drawn twice by hand.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "colour.h"
#include "image.h"
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

// What a page needs of a vector file: paths, discs, pictures, letters. Places are in pixels of the page, y down.

class VectorCanvas {
 public:
  VectorCanvas() = default;
  virtual ~VectorCanvas() = default;
  VectorCanvas(const VectorCanvas&) = delete;
  VectorCanvas& operator=(const VectorCanvas&) = delete;

  // What is drawn between these two ends at the box.
  virtual void begin_view(const Box& box) = 0;
  virtual void end_view() = 0;

  // A path, of any number of pieces, is either filled or stroked, and gone then.
  virtual void move_to(Point place) = 0;
  virtual void line_to(Point place) = 0;
  virtual void close() = 0;
  virtual void fill(Colour colour) = 0;
  virtual void stroke(Colour colour, double width, double opacity) = 0;

  // Discs of one fill and rim stand between these two; each may have its own instead.
  virtual void begin_discs(Colour fill, Colour rim, bool own_colours) = 0;
  virtual void disc(Point centre, double radius, double rim_width, Colour fill, Colour rim) = 0;
  virtual void end_discs() = 0;

  virtual void picture(const Image& image, const Box& box) = 0;
  virtual void text(const PageText& text, double width) = 0;
};

}  // namespace hfrac::viz
