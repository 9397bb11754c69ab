// SPDX-License-Identifier: BSD-3-Clause
// What a page needs of a vector file: paths, discs, pictures, letters. Places are in pixels of the page, y down.
#pragma once

#include "colour.h"
#include "image.h"
#include "page.h"

namespace hfrac::viz {

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
