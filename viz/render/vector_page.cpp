// SPDX-License-Identifier: BSD-3-Clause
#include "vector_page.h"

#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace hfrac::viz {
namespace {

using ToPage = std::function<Point(double x, double y)>;

Colour colour_at(vtkDataArray* colours, vtkIdType index) {
  double rgb[3] = {0, 0, 0};
  colours->GetTuple(index, rgb);
  return {static_cast<std::uint8_t>(rgb[0]), static_cast<std::uint8_t>(rgb[1]),
          static_cast<std::uint8_t>(rgb[2])};
}

Colour colour_of(const double* rgb) {
  const auto part = [](double value) { return static_cast<std::uint8_t>(std::lround(255 * value)); };
  return {part(rgb[0]), part(rgb[1]), part(rgb[2])};
}

bool same(Colour a, Colour b) {
  return a.red == b.red && a.green == b.green && a.blue == b.blue;
}

void trace(vtkPolyData* shapes, vtkIdType count, const vtkIdType* corners, const ToPage& place,
           VectorCanvas& canvas) {
  for (vtkIdType i = 0; i < count; ++i) {
    double at[3];
    shapes->GetPoint(corners[i], at);
    const Point point = place(at[0], at[1]);
    i == 0 ? canvas.move_to(point) : canvas.line_to(point);
  }
}

// Neighbours of one colour share a path.
void draw_polygons(vtkPolyData* shapes, const ToPage& place, VectorCanvas& canvas) {
  vtkDataArray* colours = shapes->GetPointData()->GetScalars();
  if (colours == nullptr) return;
  bool open = false;
  Colour current;
  shapes->GetPolys()->InitTraversal();
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  while (shapes->GetPolys()->GetNextCell(count, corners) != 0) {
    if (count < 3) continue;
    const Colour colour = colour_at(colours, corners[0]);
    if (open && !same(colour, current)) canvas.fill(current);
    current = colour;
    open = true;
    trace(shapes, count, corners, place, canvas);
    canvas.close();
  }
  if (open) canvas.fill(current);
}

void draw_lines(vtkPolyData* shapes, vtkProperty* property, const ToPage& place, double factor,
                VectorCanvas& canvas) {
  if (shapes->GetLines()->GetNumberOfCells() == 0) return;
  shapes->GetLines()->InitTraversal();
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  while (shapes->GetLines()->GetNextCell(count, corners) != 0) trace(shapes, count, corners, place, canvas);
  canvas.stroke(colour_of(property->GetColor()), property->GetLineWidth() / factor, property->GetOpacity());
}

// The rim lies inside the disc and fades where discs are only a few pixels large, as in the pixels.
void draw_discs(vtkPolyData* cloud, vtkProperty* property, const ToPage& place, double metres_per_pixel,
                VectorCanvas& canvas) {
  vtkDataArray* radius = cloud->GetPointData()->GetArray("radius");
  vtkDataArray* colours = cloud->GetPointData()->GetScalars();
  if (radius == nullptr) return;
  const Colour fill = colour_of(property->GetColor());
  const Colour rim = colour_of(property->GetEdgeColor());
  canvas.begin_discs(fill, rim, colours != nullptr);
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i) {
    double at[3];
    cloud->GetPoint(i, at);
    const double pixels = radius->GetTuple1(i) / metres_per_pixel;
    const double thickness = pixels < 1.5 ? 0.0 : std::min(1.0, 0.25 * pixels);
    const Colour own = colours != nullptr ? colour_at(colours, i) : fill;
    canvas.disc(place(at[0], at[1]), pixels - thickness / 2, thickness, own,
                colours != nullptr ? mixed(own, {}, 0.18) : rim);
  }
  canvas.end_discs();
}

void draw_picture(vtkTexture* texture, const Box& box, VectorCanvas& canvas) {
  vtkImageData* image = texture->GetInput();
  int size[3] = {0, 0, 0};
  image->GetDimensions(size);
  Image pixels{size[0], size[1], std::vector<std::uint8_t>(static_cast<std::size_t>(size[0]) * size[1] * 3)};
  const auto* rows = static_cast<const std::uint8_t*>(image->GetScalarPointer());
  const std::size_t row = static_cast<std::size_t>(size[0]) * 3;
  for (int y = 0; y < size[1]; ++y) {  // VTK counts rows from below
    std::copy_n(rows + static_cast<std::size_t>(y) * row, row, pixels.row(size[1] - 1 - y));
  }
  canvas.picture(pixels, box);
}

void draw_view(const View& view, double factor, VectorCanvas& canvas) {
  canvas.begin_view(view.box);
  std::vector<vtkActor*> actors;
  vtkActorCollection* all = view.renderer->GetActors();
  all->InitTraversal();
  while (vtkActor* actor = all->GetNextActor()) actors.push_back(actor);
  std::stable_sort(actors.begin(), actors.end(),
                   [](vtkActor* a, vtkActor* b) { return a->GetPosition()[2] < b->GetPosition()[2]; });
  const ToPage place = [&](double x, double y) { return Point{view.to_page_x(x), view.to_page_y(y)}; };
  for (vtkActor* actor : actors) {
    if (actor->GetTexture() != nullptr) {
      draw_picture(actor->GetTexture(), view.box, canvas);
      continue;
    }
    // The point-Gaussian mapper is a polydata mapper too.
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
    if (mapper == nullptr || mapper->GetInput() == nullptr) continue;
    if (vtkPointGaussianMapper::SafeDownCast(mapper) != nullptr) {
      draw_discs(mapper->GetInput(), actor->GetProperty(), place, view.metres_per_pixel, canvas);
    } else {
      draw_polygons(mapper->GetInput(), place, canvas);
      draw_lines(mapper->GetInput(), actor->GetProperty(), place, factor, canvas);
    }
  }
  canvas.end_view();
}

}  // namespace

void draw_vectors(const PageDrawing& drawing, VectorCanvas& canvas) {
  const double factor = drawing.page->drawn_pixels();
  for (const View& view : drawing.views) draw_view(view, factor, canvas);
  if (drawing.overlay != nullptr) {
    auto* mapper = vtkPolyDataMapper::SafeDownCast(drawing.overlay->GetMapper());
    draw_polygons(
        mapper->GetInput(),
        [&](double x, double y) {
          return Point{x / factor, drawing.page->height() - y / factor};
        },
        canvas);
  }
  for (const PageText& text : drawing.texts)
    canvas.text(text, drawing.page->text_width(text.content, text.style));
}

}  // namespace hfrac::viz
