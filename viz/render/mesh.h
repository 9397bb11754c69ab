// SPDX-License-Identifier: BSD-3-Clause
// Flat coloured shapes, gathered into one VTK actor. Later shapes lie over earlier ones.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "colour.h"
#include "snapshot.h"

namespace hfrac::viz {

class Mesh {
 public:
  Mesh() = default;
  // Of what meets this part of the plane alone.
  explicit Mesh(const Bounds& seen) : seen_(seen) {}
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
  std::optional<Bounds> seen_;
};

// Throws unless OpenGL draws so many corners at once: their places go into one buffer, counted in 32 bits.
void require_drawable(std::size_t corners);

}  // namespace hfrac::viz
