// SPDX-License-Identifier: BSD-3-Clause
#include "layers.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh.h"

namespace hfrac::viz {
namespace {

bool has_well_domain(const Flow& flow) {
  return std::any_of(flow.domains.begin(), flow.domains.end(),
                     [](const Domain& domain) { return domain.well; });
}

std::span<const Point> corners_of(const Flow& flow, const Domain& domain) {
  return std::span<const Point>(flow.corners).subspan(domain.first_corner, domain.corner_count);
}

}  // namespace

vtkSmartPointer<vtkActor> bond_layer(std::span<const Segment> bonds, Colour colour, double width) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  points->SetNumberOfPoints(static_cast<vtkIdType>(2 * bonds.size()));
  vtkIdType next = 0;
  for (const Segment& bond : bonds) {
    lines->InsertNextCell(2);
    for (const Point& end : {bond.from, bond.to}) {
      points->SetPoint(next, end.x, end.y, 0.0);
      lines->InsertCellPoint(next++);
    }
  }
  vtkNew<vtkPolyData> network;
  network->SetPoints(points);
  network->SetLines(lines);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(network);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  actor->GetProperty()->SetLineWidth(static_cast<float>(std::max(1.0, width)));
  if (width < 1.0) actor->GetProperty()->SetOpacity(std::max(0.1, width));
  actor->SetPosition(0.0, 0.0, depth::bonds);
  return actor;
}

vtkSmartPointer<vtkActor> crack_layer(std::span<const Crack> cracks, double half_width, double casing) {
  Mesh mesh;
  if (casing > 0) {
    for (const Crack& crack : cracks) {
      mesh.band(crack.line, half_width + casing, half_width / 2 + casing, palette().paper);
    }
  }
  // Shear over tension: it is the rarer of the two.
  for (const CrackMode mode : {CrackMode::tension, CrackMode::shear}) {
    const Colour colour = mode == CrackMode::tension ? palette().tension : palette().shear;
    for (const Crack& crack : cracks) {
      if (crack.mode == mode) mesh.band(crack.line, half_width, half_width / 2, colour);
    }
  }
  return mesh.actor(depth::cracks);
}

vtkSmartPointer<vtkActor> aperture_layer(std::span<const Crack> cracks, double widest, double half_width) {
  constexpr double narrowest_share = 0.3;  // a closed crack is still a line
  std::vector<Crack> by_aperture(cracks.begin(), cracks.end());
  std::stable_sort(by_aperture.begin(), by_aperture.end(),
                   [](const Crack& a, const Crack& b) { return a.aperture < b.aperture; });
  Mesh mesh;
  for (const Crack& crack : by_aperture) {
    const double share = widest > 0 ? std::min(1.0, crack.aperture / widest) : 0.0;
    const double half = half_width * (narrowest_share + (1 - narrowest_share) * share);
    mesh.band(crack.line, half, half_width * narrowest_share / 2, palette().narrow->at(share));
  }
  return mesh.actor(depth::cracks);
}

vtkSmartPointer<vtkActor> domain_layer(const Flow& flow, double lowest, double highest) {
  const double range = highest > lowest ? highest - lowest : 1.0;
  Mesh mesh;
  for (const Domain& domain : flow.domains) {
    mesh.polygon(corners_of(flow, domain), pressure_map.at((domain.pressure - lowest) / range));
  }
  return mesh.actor(depth::domains);
}

vtkSmartPointer<vtkActor> domain_layer(const Flow& flow, std::span<const Colour> colours) {
  Mesh mesh;
  for (const Domain& domain : flow.domains) {
    if (domain.cell < colours.size()) mesh.polygon(corners_of(flow, domain), colours[domain.cell]);
  }
  return mesh.actor(depth::domains);
}

vtkSmartPointer<vtkActor> well_layer(const Flow& flow, std::span<const WellPlace> wells,
                                     double smallest_radius, Colour colour) {
  Mesh mesh;
  if (has_well_domain(flow)) {
    for (const Domain& domain : flow.domains) {
      if (domain.well) mesh.polygon(corners_of(flow, domain), colour);
    }
  } else {
    for (const WellPlace& well : wells) {
      mesh.circle({well.x, well.y}, std::max(well.radius, smallest_radius), colour);
    }
  }
  return mesh.actor(depth::wells);
}

vtkSmartPointer<vtkActor> well_rings(const Flow& flow, std::span<const WellPlace> wells, double half_width,
                                     Colour colour) {
  Mesh mesh;
  const auto outline = [&](std::span<const Point> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      mesh.band({corners[i], corners[(i + 1) % corners.size()]}, half_width, half_width / 2, colour);
    }
  };
  if (has_well_domain(flow)) {
    for (const Domain& domain : flow.domains) {
      if (domain.well) outline(corners_of(flow, domain));
    }
  } else {
    constexpr int corner_count = 64;
    for (const WellPlace& well : wells) {
      std::vector<Point> circle;
      for (int i = 0; i < corner_count; ++i) {
        const double angle = 2 * std::numbers::pi * i / corner_count;
        circle.push_back({well.x + well.radius * std::cos(angle), well.y + well.radius * std::sin(angle)});
      }
      outline(circle);
    }
  }
  return mesh.actor(depth::rings);
}

}  // namespace hfrac::viz
