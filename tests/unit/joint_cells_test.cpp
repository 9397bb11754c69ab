// SPDX-License-Identifier: BSD-3-Clause
// Permeability that joints give a host's cell, by both rules, against the tensor of parallel plates.
//
// One joint of aperture w at an angle t through a cell of side h: w^3 l / (12 h^2) (cos^2 t, sin^2 t, cos t sin t), l = h / cos t
// its length in the cell (Oda, Geotechnique 35 (1985) 483; Witherspoon et al., Water Resour. Res. 16 (1980) 1016). Those of
// joints that cross add up.
#include <gtest/gtest.h>

#include <cmath>

#include "flow/aperture.hpp"
#include "host/cell_report.hpp"
#include "model.hpp"
#include "model/joint_pores.hpp"
#include "solid/joints.hpp"

namespace joint_cells_test {

using namespace testing_unit;

constexpr double low = 15.0, side = 70.0, w = 5e-4, rock = 1e-18;

// A rigid block of 100 m whose joints are w wide, and one cell of 70 m in its middle.
struct Jointed {
  Options o = dry_options(4000);
  Assembly a;
  Network n;
  HostGrid grid = HostGrid::regular(1, 1, {low, low}, {side, side}, 0.0);
  double oda_matrix = 1.0;

  explicit Jointed(const std::vector<double>& degrees) {
    o.model_width = o.model_height = 100.0;
    o.flow_scheme = choice(FlowScheme::implicit_scheme);
    o.flow_permeability = rock;
    o.flow_aperture_limit = 0.01;
    const Discs discs = packed(o);
    ContactGraph graph = build_contact_graph(discs.x, discs.y, discs.radius, {}, o.bond_gap_tolerance);
    Faces faces = build_faces(graph);
    a = build_assembly(std::move(graph), o);
    std::vector<JointOptions> joints;
    for (const double angle : degrees) {
      const double t = angle * pi / 180.0;
      const Vec2 half{60.0 * std::cos(t), 60.0 * std::sin(t)};
      JointOptions joint;
      joint.x1 = 50.0 - half.x;
      joint.y1 = 50.0 - half.y;
      joint.x2 = 50.0 + half.x;
      joint.y2 = 50.0 + half.y;
      joint.state = static_cast<std::int64_t>(JointState::smooth_broken);
      joint.aperture = w;
      joints.push_back(joint);
    }
    CrackLog cracks;
    apply_joints(a, joints, o, cracks);
    n = build_network(std::move(faces), a, {}, o);
    std::vector<double> pressure;
    calibrate_aperture(n, a, o, {}, pressure);
    oda_matrix = rock / uniform_gradient_permeability(a, n, o.fluid_viscosity);
    begin_joint_pores(n, a, o);
    update_apertures(n, a, o);
    grid.lay_over(a, n);
  }
  [[nodiscard]] CellReport cell(Upscaling rule) const {
    return report_cells(grid, a, n, o, rule, oda_matrix)[0];
  }
};

void expect_plates(const std::vector<double>& degrees, Upscaling rule, double tolerance) {
  const Jointed model(degrees);
  const CellReport cell = model.cell(rule);
  double plates[3] = {}, length = 0.0;
  for (const double angle : degrees) {
    const double c = std::cos(angle * pi / 180.0), s = std::sin(angle * pi / 180.0);
    const double inside = side / std::max(std::abs(c), std::abs(s)),
                 k = w * w * w * inside / (12.0 * side * side);
    plates[0] += k * c * c;
    plates[1] += k * s * s;
    plates[2] += k * c * s;
    length += inside;
  }
  const double scale = plates[0] + plates[1];
  for (int part = 0; part < 3; ++part)
    EXPECT_NEAR(cell.permeability[part], plates[part], tolerance * scale) << "part " << part;
  EXPECT_NEAR(cell.matrix_permeability, rock, 0.1 * rock);
  EXPECT_NEAR(cell.crack_length, length, 0.01 * length);
  EXPECT_NEAR(cell.fracture_porosity, length * w / (side * side), 0.01 * length * w / (side * side));
}

TEST(JointCells, OdaIsTheTensorOfParallelPlates) {
  expect_plates({0.0}, Upscaling::oda, 0.001);
  expect_plates({30.0}, Upscaling::oda, 0.001);
  expect_plates({-20.0, 65.0}, Upscaling::oda, 0.001);
}

TEST(JointCells, FlowThroughTheNetworkIsThatBetweenParallelPlates) {
  expect_plates({0.0}, Upscaling::flow, 0.01);
  expect_plates({30.0}, Upscaling::flow, 0.01);
  expect_plates({-20.0, 65.0}, Upscaling::flow, 0.015);
}

// Where three meet, bonds are left to the rock and passed by the joints' fluid: the rock's permeability must not know of it.
TEST(JointCells, RockIsAsTightWhereJointsMeet) {
  const std::vector<double> star = {0.0, 60.0, 120.0};
  EXPECT_FALSE(Jointed(star).a.smooth.bridges.empty());
  expect_plates(star, Upscaling::oda, 0.01);
  expect_plates(star, Upscaling::flow, 0.01);
}

}  // namespace joint_cells_test
