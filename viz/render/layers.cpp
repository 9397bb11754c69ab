// SPDX-License-Identifier: BSD-3-Clause
#include "layers.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

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

bool lies_in(std::span<const Point> corners, Point at) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i], b = corners[(i + 1) % corners.size()];
    if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) * (b.x - a.x) / (b.y - a.y))
      inside = !inside;
  }
  return inside;
}

}  // namespace

vtkSmartPointer<vtkActor> bond_layer(std::span<const Segment> bonds, const Bounds& seen, Colour colour,
                                     double width) {
  const auto meets = [&](const Segment& bond) {
    Bounds bounds;
    bounds.include(bond.from);
    bounds.include(bond.to);
    return bounds.meet(seen);
  };
  const auto count = std::count_if(bonds.begin(), bonds.end(), meets);
  require_drawable(2 * static_cast<std::size_t>(count));
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  points->SetNumberOfPoints(2 * static_cast<vtkIdType>(count));
  vtkIdType next = 0;
  for (const Segment& bond : bonds) {
    if (!meets(bond)) continue;
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

vtkSmartPointer<vtkActor> domain_layer(const Flow& flow, const Bounds& seen, double lowest, double highest) {
  const double range = highest > lowest ? highest - lowest : 1.0;
  Mesh mesh(seen);
  for (const Domain& domain : flow.domains) {
    mesh.polygon(corners_of(flow, domain), pressure_map.at((domain.pressure - lowest) / range));
  }
  return mesh.actor(depth::domains);
}

vtkSmartPointer<vtkActor> domain_layer(const Flow& flow, const Bounds& seen,
                                       std::span<const Colour> colours) {
  Mesh mesh(seen);
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
  // The hole that was asked for; where that is not known, and around a pore that was made a well, the domain.
  const bool domains = has_well_domain(flow);
  std::vector<Point> asked;
  for (const WellPlace& well : wells) {
    const double radius = well.asked > 0 || domains ? well.asked : well.radius;
    if (radius <= 0) continue;
    constexpr int corner_count = 64;
    std::vector<Point> circle;
    for (int i = 0; i < corner_count; ++i) {
      const double angle = 2 * std::numbers::pi * i / corner_count;
      circle.push_back({well.x + radius * std::cos(angle), well.y + radius * std::sin(angle)});
    }
    outline(circle);
    asked.push_back({well.x, well.y});
  }
  for (const Domain& domain : flow.domains) {
    const auto corners = corners_of(flow, domain);
    const bool drawn =
        std::any_of(asked.begin(), asked.end(), [&](Point at) { return lies_in(corners, at); });
    if (domain.well && !drawn) outline(corners);
  }
  return mesh.actor(depth::rings);
}

// Layers whose bands say something by colour or width: force chains, cracks by their age, bonds by anything.

vtkSmartPointer<vtkActor> force_layer(std::span<const BondForce> bonds, const Bounds& seen, double largest,
                                      double half_width) {
  constexpr double weakest = 0.02;  // of the largest
  std::vector<BondForce> by_force;
  for (const BondForce& bond : bonds) {
    if (std::fabs(bond.normal) > weakest * largest) by_force.push_back(bond);
  }
  // Strong over weak, so that chains are not cut.
  std::stable_sort(by_force.begin(), by_force.end(), [](const BondForce& a, const BondForce& b) {
    return std::fabs(a.normal) < std::fabs(b.normal);
  });
  Mesh mesh(seen);
  for (const BondForce& bond : by_force) {
    const double half = half_width * std::min(1.0, std::fabs(bond.normal) / largest);
    mesh.band(bond.line, half, half / 2, bond.normal > 0 ? palette().pull : palette().push);
  }
  return mesh.actor(depth::bonds);
}

vtkSmartPointer<vtkActor> coloured_cracks(std::span<const Crack> cracks, std::span<const Colour> colours,
                                          double half_width) {
  Mesh mesh;
  for (const Crack& crack : cracks) {
    if (crack.cell < colours.size()) mesh.band(crack.line, half_width, half_width / 2, colours[crack.cell]);
  }
  return mesh.actor(depth::cracks);
}

vtkSmartPointer<vtkActor> coloured_bonds(std::span<const Segment> bonds, const Bounds& seen,
                                         std::span<const Colour> colours, double half_width) {
  Mesh mesh(seen);
  for (std::size_t i = 0; i < bonds.size() && i < colours.size(); ++i) {
    mesh.band(bonds[i], half_width, half_width / 2, colours[i]);
  }
  return mesh.actor(depth::bonds);
}

vtkSmartPointer<vtkActor> joint_layer(std::span<const Segment> contacts, std::span<const Colour> colours,
                                      double half_width, double casing) {
  Mesh mesh;
  for (const Segment& contact : contacts)
    mesh.band(contact, half_width + casing, casing, palette().faint_ink);
  for (std::size_t i = 0; i < contacts.size() && i < colours.size(); ++i)
    mesh.band(contacts[i], half_width, 0, colours[i]);
  return mesh.actor(depth::cracks);
}

// Discs by vtkPointGaussianMapper: one triangle per disc, and a few lines of shader that keep its round part
// and darken its rim. Ten thousand discs cost as much as a few hundred polygons would.

namespace {

std::string shader_colour(Colour colour) {
  const auto part = [](std::uint8_t value) { return std::to_string(value) + ".0"; };
  return "vec3(" + part(colour.red) + ", " + part(colour.green) + ", " + part(colour.blue) + ") / 255.0";
}

// offsetVCVSOutput is the place in the disc in units of its radius. The rim is about two drawn pixels wide,
// at most a quarter of the radius, and fades out where discs are only a few pixels large.
std::string disc_shader(const std::string& fill, const std::string& rim) {
  return "//VTK::Color::Impl\n"
         "float discRadius = length(offsetVCVSOutput.xy);\n"
         "float discPixel = max(fwidth(discRadius), 1e-6);\n"
         "if (discRadius > 1.0) discard;\n"
         "float discRimWidth = min(2.0 * discPixel, 0.25);\n"
         "float discRim = smoothstep(1.0 - discRimWidth - discPixel, 1.0 - discRimWidth, discRadius);\n"
         "discRim *= clamp((1.0 / discPixel - 2.0) / 4.0, 0.0, 1.0);\n"
         "vec3 discFill = " +
         fill +
         ";\n"
         "ambientColor = vec3(0.0);\n"
         "diffuseColor = mix(discFill, " +
         rim + ", discRim);\n";
}

vtkSmartPointer<vtkPolyData> disc_cloud(const Discs& discs, double pixel) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> radius;
  radius->SetName("radius");
  points->SetNumberOfPoints(static_cast<vtkIdType>(discs.discs.size()));
  radius->SetNumberOfTuples(static_cast<vtkIdType>(discs.discs.size()));
  for (std::size_t i = 0; i < discs.discs.size(); ++i) {
    const Disc& disc = discs.discs[i];
    points->SetPoint(static_cast<vtkIdType>(i), disc.centre.x, disc.centre.y, 0.0);
    radius->SetValue(static_cast<vtkIdType>(i), std::max(disc.radius, pixel));
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  cloud->GetPointData()->AddArray(radius);
  return cloud;
}

vtkSmartPointer<vtkActor> disc_actor(vtkPolyData* cloud, const std::string& shader, bool own_colours) {
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(cloud);
  mapper->SetScaleArray("radius");
  mapper->SetScaleFactor(1.0);
  mapper->EmissiveOff();
  mapper->SetTriangleScale(1.0F);
  mapper->SetScalarVisibility(own_colours ? 1 : 0);
  mapper->SetSplatShaderCode(shader.c_str());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->SetPosition(0.0, 0.0, depth::discs);
  return actor;
}

}  // namespace

vtkSmartPointer<vtkActor> disc_layer(const Discs& discs, Colour fill, Colour rim, double pixel) {
  auto actor =
      disc_actor(disc_cloud(discs, pixel), disc_shader(shader_colour(fill), shader_colour(rim)), false);
  // The shader knows its colours; these are for whoever writes the page as vectors.
  actor->GetProperty()->SetColor(fill.red / 255.0, fill.green / 255.0, fill.blue / 255.0);
  actor->GetProperty()->SetEdgeColor(rim.red / 255.0, rim.green / 255.0, rim.blue / 255.0);
  return actor;
}

vtkSmartPointer<vtkActor> disc_layer(const Discs& discs, std::span<const Colour> fills, double pixel) {
  const vtkSmartPointer<vtkPolyData> cloud = disc_cloud(discs, pixel);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(discs.discs.size()));
  for (std::size_t i = 0; i < discs.discs.size() && i < fills.size(); ++i) {
    const std::array<unsigned char, 3> rgb = {fills[i].red, fills[i].green, fills[i].blue};
    colours->SetTypedTuple(static_cast<vtkIdType>(i), rgb.data());
  }
  cloud->GetPointData()->SetScalars(colours);
  return disc_actor(cloud, disc_shader("diffuseColor", "discFill * 0.82"), true);
}

}  // namespace hfrac::viz
