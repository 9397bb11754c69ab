// SPDX-License-Identifier: BSD-3-Clause
// Discs by vtkPointGaussianMapper: one triangle per disc, and a few lines of shader that keep its round part
// and darken its rim. Ten thousand discs cost as much as a few hundred polygons would.
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <string>

#include "layers.h"

namespace hfrac::viz {
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
