// SPDX-License-Identifier: BSD-3-Clause
#include "disc_detail.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <thread>
#include <vector>

#include "layers.h"
#include "run/threads.hpp"

namespace hfrac::viz {

// Each worker takes a band of rows and all discs that touch it, so nothing is written twice and the picture does not
// depend on how many there are. A disc below a pixel is spread over the four pixels around its centre, its area
// divided as the distances say; a larger one covers the inner pixels wholly and those at its edge in part.

namespace {

constexpr double smallest_round = 0.75;  // [pixel] radius from which a disc has a shape

struct Cover {
  float red = 0;
  float green = 0;
  float blue = 0;
  float area = 0;  // [pixel^2]
};

class Band {
 public:
  Band(int width, int first_row, int end_row)
      : width_(width),
        first_(first_row),
        end_(end_row),
        cover_(static_cast<std::size_t>(width) * (end_row - first_row)) {}

  void add(double x, double y, double radius, Colour colour) {
    const double reach = std::max(radius, 1.0) + 1;
    if (y + reach < first_ || y - reach > end_ || x + reach < 0 || x - reach > width_) return;
    if (radius < smallest_round) {
      add_speck(x - 0.5, y - 0.5, std::acos(-1.0) * radius * radius, colour);
    } else {
      add_round(x, y, radius, colour);
    }
  }

  void write(Raster& raster, Colour paper) const {
    std::uint8_t* pixel = raster.rgb.data() + static_cast<std::size_t>(first_) * width_ * 3;
    for (const Cover& cover : cover_) {
      // Where discs overlap they share the pixel, where they leave room the paper fills it.
      const float part = 1 / std::max(1.0F, cover.area);
      const float rest = std::max(0.0F, 1 - cover.area);
      constexpr float half = 0.5F;  // to the nearest, without a call for each pixel
      pixel[0] = static_cast<std::uint8_t>(cover.red * part + rest * paper.red + half);
      pixel[1] = static_cast<std::uint8_t>(cover.green * part + rest * paper.green + half);
      pixel[2] = static_cast<std::uint8_t>(cover.blue * part + rest * paper.blue + half);
      pixel += 3;
    }
  }

 private:
  void put(int column, int row, double area, Colour colour) {
    if (column < 0 || column >= width_ || row < first_ || row >= end_ || !(area > 0)) return;
    Cover& cover = cover_[static_cast<std::size_t>(row - first_) * width_ + column];
    const auto weight = static_cast<float>(area);
    cover.red += weight * colour.red;
    cover.green += weight * colour.green;
    cover.blue += weight * colour.blue;
    cover.area += weight;
  }

  void add_speck(double x, double y, double area, Colour colour) {
    const double column = std::floor(x);
    const double row = std::floor(y);
    const double right = x - column;
    const double upper = y - row;
    const int i = static_cast<int>(column);
    const int j = static_cast<int>(row);
    put(i, j, area * (1 - right) * (1 - upper), colour);
    put(i + 1, j, area * right * (1 - upper), colour);
    put(i, j + 1, area * (1 - right) * upper, colour);
    put(i + 1, j + 1, area * right * upper, colour);
  }

  void add_round(double x, double y, double radius, Colour colour) {
    const int lowest = std::max(first_, static_cast<int>(std::floor(y - radius - 0.5)));
    const int highest = std::min(end_ - 1, static_cast<int>(std::floor(y + radius + 0.5)));
    for (int row = lowest; row <= highest; ++row) {
      const double dy = row + 0.5 - y;
      const double half = std::sqrt(std::max(0.0, (radius + 0.5) * (radius + 0.5) - dy * dy));
      const int from = std::max(0, static_cast<int>(std::floor(x - half)));
      const int to = std::min(width_ - 1, static_cast<int>(std::floor(x + half)));
      for (int column = from; column <= to; ++column) {
        const double distance = std::hypot(column + 0.5 - x, dy);
        put(column, row, std::clamp(radius + 0.5 - distance, 0.0, 1.0), colour);
      }
    }
  }

  int width_;
  int first_;
  int end_;
  std::vector<Cover> cover_;
};

}  // namespace

Raster disc_raster(const Discs& discs, std::span<const Colour> fills, const Extent& extent, int width,
                   int height) {
  Raster raster{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  const double across = width / extent.width;
  const double up = height / extent.height;
  const Colour paper = palette().paper;
  const bool single = fills.size() < discs.discs.size();
  const auto draw = [&](int first_row, int end_row) {
    Band band(width, first_row, end_row);
    for (std::size_t i = 0; i < discs.discs.size(); ++i) {
      const Disc& disc = discs.discs[i];
      band.add((disc.centre.x - extent.left) * across, (disc.centre.y - extent.bottom) * up,
               disc.radius * across, fills[single ? 0 : i]);
    }
    band.write(raster, paper);
  };
  const int workers =
      std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, std::min(8, height));
  run::share_out(workers, static_cast<std::size_t>(workers), [&](std::size_t, std::size_t band) {
    const int k = static_cast<int>(band);
    draw(height * k / workers, height * (k + 1) / workers);
  });
  return raster;
}

namespace {

constexpr double smallest_radius = 0.75;      // [pixel] of a disc drawn as a point
constexpr std::size_t most_points = 300'000;  // in the view; beyond it points are slower than density
constexpr std::size_t worth_sorting_out = 20'000;

bool in_view(const Disc& disc, const Extent& extent) {
  return disc.centre.x + disc.radius >= extent.left &&
         disc.centre.x - disc.radius <= extent.left + extent.width &&
         disc.centre.y + disc.radius >= extent.bottom &&
         disc.centre.y - disc.radius <= extent.bottom + extent.height;
}

// The raster as a picture on a rectangle that fills the view. It lies below the wells, which discs that small do not
// visibly reach into: a transparent one above them would cost VTK half a gigabyte for its transparency.
vtkSmartPointer<vtkActor> picture_actor(const View& view, const Raster& raster) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(raster.width, raster.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::memcpy(image->GetScalarPointer(), raster.rgb.data(), raster.rgb.size());
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();
  texture->SetColorModeToDirectScalars();
  vtkNew<vtkPlaneSource> plane;
  const Extent& extent = view.extent;
  plane->SetOrigin(extent.left, extent.bottom, 0);
  plane->SetPoint1(extent.left + extent.width, extent.bottom, 0);
  plane->SetPoint2(extent.left, extent.bottom + extent.height, 0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  actor->GetProperty()->LightingOff();
  actor->SetPosition(0.0, 0.0, depth::wells - 0.5);
  return actor;
}

vtkSmartPointer<vtkActor> density(const View& view, const Discs& discs, std::span<const Colour> fills) {
  const int width = std::max(1, static_cast<int>(std::lround(view.box.width)));
  const int height = std::max(1, static_cast<int>(std::lround(view.box.height)));
  return picture_actor(view, disc_raster(discs, fills, view.extent, width, height));
}

}  // namespace

bool drawn_as_density(const View& view, const Discs& discs) {
  double sum = 0;
  std::size_t count = 0;
  for (const Disc& disc : discs.discs) {
    if (!in_view(disc, view.extent)) continue;
    sum += disc.radius;
    ++count;
  }
  if (count == 0) return false;
  const double radius = sum / static_cast<double>(count) / view.metres_per_pixel;
  return radius < smallest_radius || count > most_points;
}

vtkSmartPointer<vtkActor> discs_in_view(const View& view, const Discs& discs, Colour fill, Colour rim,
                                        double drawn_pixel) {
  if (drawn_as_density(view, discs)) return density(view, discs, std::array<Colour, 1>{fill});
  if (discs.discs.size() < worth_sorting_out) return disc_layer(discs, fill, rim, drawn_pixel);
  Discs seen;
  for (const Disc& disc : discs.discs) {
    if (in_view(disc, view.extent)) seen.discs.push_back(disc);
  }
  return disc_layer(seen, fill, rim, drawn_pixel);
}

vtkSmartPointer<vtkActor> discs_in_view(const View& view, const Discs& discs, std::span<const Colour> fills,
                                        double drawn_pixel) {
  if (drawn_as_density(view, discs)) return density(view, discs, fills);
  Discs seen;
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < discs.discs.size() && i < fills.size(); ++i) {
    if (!in_view(discs.discs[i], view.extent)) continue;
    seen.discs.push_back(discs.discs[i]);
    colours.push_back(fills[i]);
  }
  return disc_layer(seen, colours, drawn_pixel);
}

}  // namespace hfrac::viz
