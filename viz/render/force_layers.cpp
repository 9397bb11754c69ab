// SPDX-License-Identifier: BSD-3-Clause
// Layers whose bands say something by colour or width: force chains, cracks by their age, bonds by anything.
#include <algorithm>
#include <cmath>
#include <vector>

#include "layers.h"
#include "mesh.h"

namespace hfrac::viz {

vtkSmartPointer<vtkActor> force_layer(std::span<const BondForce> bonds, double largest, double half_width) {
  constexpr double weakest = 0.02;  // of the largest
  std::vector<BondForce> by_force;
  for (const BondForce& bond : bonds) {
    if (std::fabs(bond.normal) > weakest * largest) by_force.push_back(bond);
  }
  // Strong over weak, so that chains are not cut.
  std::stable_sort(by_force.begin(), by_force.end(), [](const BondForce& a, const BondForce& b) {
    return std::fabs(a.normal) < std::fabs(b.normal);
  });
  Mesh mesh;
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

vtkSmartPointer<vtkActor> coloured_bonds(std::span<const Segment> bonds, std::span<const Colour> colours,
                                         double half_width) {
  Mesh mesh;
  for (std::size_t i = 0; i < bonds.size() && i < colours.size(); ++i) {
    mesh.band(bonds[i], half_width, half_width / 2, colours[i]);
  }
  return mesh.actor(depth::bonds);
}

}  // namespace hfrac::viz
