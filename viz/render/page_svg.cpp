// SPDX-License-Identifier: BSD-3-Clause
#include "page_svg.h"

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
#include <charconv>
#include <cmath>
#include <functional>

#include "html.h"
#include "svg_text.h"

namespace hfrac::viz {
namespace {

// Two decimals of a pixel, without the zeros behind them.
std::string decimal(double value) {
  char text[40];
  const double rounded = std::round(value * 100) / 100;
  const auto end = std::to_chars(text, text + sizeof text, rounded == 0 ? 0.0 : rounded).ptr;
  return {text, end};
}

using Place = std::function<Point(double x, double y)>;

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

class Writer {
 public:
  std::string text;

  // Neighbours of one colour share a path.
  void polygons(vtkPolyData* shapes, const Place& place) {
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
      if (!open || !same(colour, current)) {
        if (open) text += "\"/>\n";
        text.append("<path fill=\"").append(hexadecimal(colour)).append("\" d=\"");
        current = colour;
        open = true;
      }
      for (vtkIdType i = 0; i < count; ++i) {
        double at[3];
        shapes->GetPoint(corners[i], at);
        const Point point = place(at[0], at[1]);
        text.append(i == 0 ? "M" : "L").append(decimal(point.x)).append(" ").append(decimal(point.y));
      }
      text += "Z";
    }
    if (open) text += "\"/>\n";
  }

  void lines(vtkPolyData* shapes, vtkProperty* property, const Place& place, double factor) {
    if (shapes->GetLines()->GetNumberOfCells() == 0) return;
    text.append("<path fill=\"none\" stroke=\"")
        .append(hexadecimal(colour_of(property->GetColor())))
        .append("\" stroke-width=\"")
        .append(decimal(property->GetLineWidth() / factor))
        .append("\" stroke-opacity=\"")
        .append(decimal(property->GetOpacity()))
        .append("\" d=\"");
    shapes->GetLines()->InitTraversal();
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    while (shapes->GetLines()->GetNextCell(count, corners) != 0) {
      for (vtkIdType i = 0; i < count; ++i) {
        double at[3];
        shapes->GetPoint(corners[i], at);
        const Point point = place(at[0], at[1]);
        text.append(i == 0 ? "M" : "L").append(decimal(point.x)).append(" ").append(decimal(point.y));
      }
    }
    text += "\"/>\n";
  }

  // The rim lies inside the disc and fades where discs are only a few pixels large, as in the pixels.
  void discs(vtkPolyData* cloud, vtkProperty* property, const Place& place, double metres_per_pixel) {
    vtkDataArray* radius = cloud->GetPointData()->GetArray("radius");
    vtkDataArray* colours = cloud->GetPointData()->GetScalars();
    if (radius == nullptr) return;
    const Colour fill = colour_of(property->GetColor());
    const Colour rim = colour_of(property->GetEdgeColor());
    if (colours == nullptr)
      text.append("<g fill=\"")
          .append(hexadecimal(fill))
          .append("\" stroke=\"")
          .append(hexadecimal(rim))
          .append("\">\n");
    if (colours != nullptr) text += "<g>\n";
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i) {
      double at[3];
      cloud->GetPoint(i, at);
      const Point centre = place(at[0], at[1]);
      const double pixels = radius->GetTuple1(i) / metres_per_pixel;
      const double thickness = pixels < 1.5 ? 0.0 : std::min(1.0, 0.25 * pixels);
      text.append("<circle cx=\"")
          .append(decimal(centre.x))
          .append("\" cy=\"")
          .append(decimal(centre.y))
          .append("\" r=\"")
          .append(decimal(pixels - thickness / 2))
          .append("\" stroke-width=\"")
          .append(decimal(thickness))
          .append("\"");
      if (colours != nullptr) {
        const Colour own = colour_at(colours, i);
        text.append(" fill=\"")
            .append(hexadecimal(own))
            .append("\" stroke=\"")
            .append(hexadecimal(mixed(own, {}, 0.18)))
            .append("\"");
      }
      text += "/>\n";
    }
    text += "</g>\n";
  }

  void picture(vtkTexture* texture, const Box& box) {
    vtkImageData* image = texture->GetInput();
    int size[3] = {0, 0, 0};
    image->GetDimensions(size);
    Image pixels{size[0], size[1],
                 std::vector<std::uint8_t>(static_cast<std::size_t>(size[0]) * size[1] * 3)};
    const auto* rows = static_cast<const std::uint8_t*>(image->GetScalarPointer());
    const std::size_t row = static_cast<std::size_t>(size[0]) * 3;
    for (int y = 0; y < size[1]; ++y) {  // VTK counts rows from below
      std::copy_n(rows + static_cast<std::size_t>(y) * row, row,
                  pixels.rgb.begin() +
                      static_cast<std::ptrdiff_t>((size[1] - 1 - static_cast<std::size_t>(y)) * row));
    }
    const std::vector<std::uint8_t> file = png(pixels);
    text.append("<image x=\"")
        .append(decimal(box.left))
        .append("\" y=\"")
        .append(decimal(box.top))
        .append("\" width=\"")
        .append(decimal(box.width))
        .append("\" height=\"")
        .append(decimal(box.height))
        .append("\" preserveAspectRatio=\"none\" href=\"data:image/png;base64,")
        .append(base64(file))
        .append("\"/>\n");
  }

  void letters(const PageText& item) {
    const TextStyle& style = item.style;
    text.append("<text x=\"")
        .append(decimal(item.x))
        .append("\" y=\"")
        .append(decimal(item.y))
        .append("\" font-size=\"")
        .append(decimal(style.size))
        .append("\" fill=\"")
        .append(hexadecimal(style.colour))
        .append("\"");
    if (style.bold) text += " font-weight=\"bold\"";
    if (style.align == Align::centre) text += " text-anchor=\"middle\"";
    if (style.align == Align::right) text += " text-anchor=\"end\"";
    if (style.upwards)
      text.append(" transform=\"rotate(-90 ")
          .append(decimal(item.x))
          .append(" ")
          .append(decimal(item.y))
          .append(")\"");
    text.append(">").append(escaped(item.content)).append("</text>\n");
  }
};

void write_view(Writer& writer, const View& view, int number, double factor) {
  const std::string name = "view" + std::to_string(number);
  writer.text.append("<clipPath id=\"")
      .append(name)
      .append("\"><rect x=\"")
      .append(decimal(view.box.left))
      .append("\" y=\"")
      .append(decimal(view.box.top))
      .append("\" width=\"")
      .append(decimal(view.box.width))
      .append("\" height=\"")
      .append(decimal(view.box.height))
      .append("\"/></clipPath>\n");
  writer.text.append("<g clip-path=\"url(#").append(name).append(")\">\n");
  std::vector<vtkActor*> actors;
  vtkActorCollection* all = view.renderer->GetActors();
  all->InitTraversal();
  while (vtkActor* actor = all->GetNextActor()) actors.push_back(actor);
  std::stable_sort(actors.begin(), actors.end(),
                   [](vtkActor* a, vtkActor* b) { return a->GetPosition()[2] < b->GetPosition()[2]; });
  const Place place = [&](double x, double y) { return Point{view.to_page_x(x), view.to_page_y(y)}; };
  for (vtkActor* actor : actors) {
    if (actor->GetTexture() != nullptr) {
      writer.picture(actor->GetTexture(), view.box);
      continue;
    }
    // The point-Gaussian mapper is a polydata mapper too.
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
    if (mapper == nullptr || mapper->GetInput() == nullptr) continue;
    if (vtkPointGaussianMapper::SafeDownCast(mapper) != nullptr) {
      writer.discs(mapper->GetInput(), actor->GetProperty(), place, view.metres_per_pixel);
    } else {
      writer.polygons(mapper->GetInput(), place);
      writer.lines(mapper->GetInput(), actor->GetProperty(), place, factor);
    }
  }
  writer.text.append("</g>\n");
}

}  // namespace

std::string page_svg(const PageDrawing& drawing) {
  const std::string width = std::to_string(drawing.width);
  const std::string height = std::to_string(drawing.height);
  Writer writer;
  writer.text
      .append(
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"")
      .append(width)
      .append("\" height=\"")
      .append(height)
      .append("\" viewBox=\"0 0 ")
      .append(width)
      .append(" ")
      .append(height)
      .append("\" font-family=\"'DejaVu Sans', Verdana, sans-serif\">\n<title>")
      .append(escaped(drawing.title))
      .append("</title>\n<rect width=\"100%\" height=\"100%\" fill=\"")
      .append(hexadecimal(palette().paper))
      .append("\"/>\n");
  for (std::size_t i = 0; i < drawing.views.size(); ++i) {
    write_view(writer, drawing.views[i], static_cast<int>(i), drawing.factor);
  }
  if (drawing.overlay != nullptr) {
    const double factor = drawing.factor;
    auto* mapper = vtkPolyDataMapper::SafeDownCast(drawing.overlay->GetMapper());
    writer.polygons(mapper->GetInput(), [&](double x, double y) {
      return Point{x / factor, drawing.height - y / factor};
    });
  }
  for (const PageText& item : drawing.texts) writer.letters(item);
  writer.text.append("</svg>\n");
  return writer.text;
}

}  // namespace hfrac::viz
