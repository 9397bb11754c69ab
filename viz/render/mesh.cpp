// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "failure.h"

namespace hfrac::viz {

void require_drawable(std::size_t corners) {
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() / (3 * sizeof(float));
  if (corners > most)
    fail_drawing("a layer of " + std::to_string(corners) + " corners is more than the " +
                 std::to_string(most) + " that are drawn at once; look at a part of the model");
}

void Mesh::polygon(std::span<const Point> corners, Colour colour) {
  if (corners.size() < 3) return;
  if (seen_) {
    Bounds bounds;
    for (const Point corner : corners) bounds.include(corner);
    if (!bounds.meet(*seen_)) return;
  }
  points_.insert(points_.end(), corners.begin(), corners.end());
  colours_.insert(colours_.end(), corners.size(), colour);
  sizes_.push_back(static_cast<std::uint32_t>(corners.size()));
}

void Mesh::band(const Segment& line, double half_width, double overhang, Colour colour) {
  const double dx = line.to.x - line.from.x;
  const double dy = line.to.y - line.from.y;
  const double length = std::hypot(dx, dy);
  const double ux = length > 0 ? dx / length : 1.0;
  const double uy = length > 0 ? dy / length : 0.0;
  const Point from{line.from.x - ux * overhang, line.from.y - uy * overhang};
  const Point to{line.to.x + ux * overhang, line.to.y + uy * overhang};
  const double nx = -uy * half_width;
  const double ny = ux * half_width;
  polygon(std::array<Point, 4>{{{from.x - nx, from.y - ny},
                                {to.x - nx, to.y - ny},
                                {to.x + nx, to.y + ny},
                                {from.x + nx, from.y + ny}}},
          colour);
}

void Mesh::rectangle(Point corner, Point opposite, Colour colour) {
  polygon(std::array<Point, 4>{{corner, {opposite.x, corner.y}, opposite, {corner.x, opposite.y}}}, colour);
}

void Mesh::circle(Point centre, double radius, Colour colour) {
  constexpr int corner_count = 64;
  std::array<Point, corner_count> corners;
  for (int i = 0; i < corner_count; ++i) {
    const double angle = 2 * std::numbers::pi * i / corner_count;
    corners[i] = {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
  }
  polygon(corners, colour);
}

vtkSmartPointer<vtkActor> Mesh::actor(double depth) const {
  require_drawable(points_.size());
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  points->SetNumberOfPoints(static_cast<vtkIdType>(points_.size()));
  colours->SetNumberOfTuples(static_cast<vtkIdType>(points_.size()));
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto index = static_cast<vtkIdType>(i);
    points->SetPoint(index, points_[i].x, points_[i].y, 0.0);
    const std::array<unsigned char, 3> rgb = {colours_[i].red, colours_[i].green, colours_[i].blue};
    colours->SetTypedTuple(index, rgb.data());
  }
  vtkNew<vtkCellArray> polygons;
  vtkIdType next = 0;
  for (const std::uint32_t size : sizes_) {
    polygons->InsertNextCell(static_cast<int>(size));
    for (std::uint32_t corner = 0; corner < size; ++corner) polygons->InsertCellPoint(next++);
  }
  vtkNew<vtkPolyData> shapes;
  shapes->SetPoints(points);
  shapes->SetPolys(polygons);
  shapes->GetPointData()->SetScalars(colours);

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shapes);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->SetPosition(0.0, 0.0, depth);
  return actor;
}

}  // namespace hfrac::viz
