// SPDX-License-Identifier: BSD-3-Clause
// Lines, polygons and text in a 2-D scene of VTK; drawn pixels, y up. In the order they were added.
#pragma once

#include <vtkContextItem.h>
#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>

#include <string>
#include <vector>

#include "colour.h"
#include "snapshot.h"

namespace hfrac::viz {

class ShapeItem final : public vtkContextItem {
 public:
  static ShapeItem* New();
  vtkTypeMacro(ShapeItem, vtkContextItem)

      bool Paint(vtkContext2D* painter) override;

  void add_line(const std::vector<Point>& points, double thickness, Colour colour);
  void add_polygon(const std::vector<Point>& corners, Colour fill);
  void add_text(Point at, const std::string& content, vtkSmartPointer<vtkTextProperty> style);

  ShapeItem(const ShapeItem&) = delete;
  ShapeItem& operator=(const ShapeItem&) = delete;

 protected:
  ShapeItem() = default;
  ~ShapeItem() override = default;

 private:
  struct Shape {
    std::vector<float> points;  // x, y, x, y, ...
    double thickness = 0;       // of a line; 0: a filled polygon
    Colour colour;
    std::string text;
    vtkSmartPointer<vtkTextProperty> style;  // of text
  };
  std::vector<Shape> shapes_;
};

}  // namespace hfrac::viz
