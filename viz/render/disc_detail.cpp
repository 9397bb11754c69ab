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
#include <vector>

#include "disc_raster.h"
#include "layers.h"

namespace hfrac::viz {
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
