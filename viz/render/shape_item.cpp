// SPDX-License-Identifier: BSD-3-Clause
#include "shape_item.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>

namespace hfrac::viz {

vtkStandardNewMacro(ShapeItem)

    void ShapeItem::add_line(const std::vector<Point>& points, double thickness, Colour colour) {
  add_polygon(points, colour);
  shapes_.back().thickness = thickness;
}

void ShapeItem::add_polygon(const std::vector<Point>& corners, Colour fill) {
  Shape shape;
  shape.colour = fill;
  for (const Point& corner : corners) {
    shape.points.push_back(static_cast<float>(corner.x));
    shape.points.push_back(static_cast<float>(corner.y));
  }
  shapes_.push_back(std::move(shape));
}

void ShapeItem::add_text(Point at, const std::string& content, vtkSmartPointer<vtkTextProperty> style) {
  Shape shape;
  shape.points = {static_cast<float>(at.x), static_cast<float>(at.y)};
  shape.text = content;
  shape.style = std::move(style);
  shapes_.push_back(std::move(shape));
}

bool ShapeItem::Paint(vtkContext2D* painter) {
  for (Shape& shape : shapes_) {
    if (shape.style) {
      painter->ApplyTextProp(shape.style);
      painter->DrawString(shape.points[0], shape.points[1], shape.text.c_str());
      continue;
    }
    vtkPen* pen = painter->GetPen();
    vtkBrush* brush = painter->GetBrush();
    if (shape.thickness > 0) {
      pen->SetLineType(vtkPen::SOLID_LINE);
      pen->SetColor(shape.colour.red, shape.colour.green, shape.colour.blue, 255);
      pen->SetWidth(static_cast<float>(shape.thickness));
      painter->DrawPoly(shape.points.data(), static_cast<int>(shape.points.size() / 2));
    } else {
      pen->SetLineType(vtkPen::NO_PEN);
      brush->SetColor(shape.colour.red, shape.colour.green, shape.colour.blue, 255);
      painter->DrawPolygon(shape.points.data(), static_cast<int>(shape.points.size() / 2));
    }
  }
  return true;
}

}  // namespace hfrac::viz
