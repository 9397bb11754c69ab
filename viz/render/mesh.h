// SPDX-License-Identifier: BSD-3-Clause
// Flat coloured shapes, gathered into one VTK actor. Later shapes lie over earlier ones.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <span>
#include <vector>

#include "colour.h"
#include "snapshot.h"

namespace hfrac::viz {

class Mesh {
 public:
  void polygon(std::span<const Point> corners, Colour colour);
  // A straight band with square ends, `overhang` longer at both.
  void band(const Segment& line, double half_width, double overhang, Colour colour);
  void rectangle(Point corner, Point opposite, Colour colour);
  void circle(Point centre, double radius, Colour colour);
  bool empty() const { return sizes_.empty(); }
  // `depth` orders actors of one view: higher covers lower.
  vtkSmartPointer<vtkActor> actor(double depth) const;

 private:
  std::vector<Point> points_;
  std::vector<Colour> colours_;
  std::vector<std::uint32_t> sizes_;  // corners of each polygon
};

}  // namespace hfrac::viz
