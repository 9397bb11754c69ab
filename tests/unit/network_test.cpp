// SPDX-License-Identifier: BSD-3-Clause
// Pores and pipes: the weights of eq. 10, by which pressure pushes discs and discs squeeze pores, and pore
// volumes.
#include "model/network.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model.hpp"

namespace network_test {

using namespace testing_unit;

Options wet_options() {
  Options o = dry_options(500);
  o.flow_scheme = choice(FlowScheme::implicit_scheme);
  return o;
}

double polygon_area(const TestModel& m, std::int64_t domain) {
  double area = 0.0;
  const auto begin = m.network.corner_start[domain], end = m.network.corner_start[domain + 1];
  for (auto k = begin; k < end; ++k) {
    const Vec2 a = m.assembly.position(m.network.corner_disc[k]);
    const Vec2 b = m.assembly.position(m.network.corner_disc[k + 1 < end ? k + 1 : begin]);
    area += 0.5 * cross(a, b);
  }
  return area;
}

TEST(Network, UniformPressurePushesNoDisc) {
  // With the outside among them the corners of every disc close.
  const TestModel m(wet_options(), packed(wet_options()), {{{10.0, 10.0}, 3.0}});
  std::vector<Vec2> sum(static_cast<std::size_t>(m.assembly.disc_count()));
  for (std::size_t k = 0; k < m.network.corner_disc.size(); ++k) {
    Vec2& disc = sum[static_cast<std::size_t>(m.network.corner_disc[k])];
    disc = disc + Vec2{m.network.corner_weight[2 * k], m.network.corner_weight[2 * k + 1]};
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    EXPECT_NEAR(sum[i].x, 0.0, 1e-13) << "disc " << i;
    EXPECT_NEAR(sum[i].y, 0.0, 1e-13) << "disc " << i;
  }
}

TEST(Network, RigidTranslationChangesNoVolume) {
  const Options o = wet_options();
  const TestModel m(o, packed(o), {{{10.0, 10.0}, 3.0}});
  for (std::int64_t d = 0; d < m.network.domain_count(); ++d) {
    double x = 0.0, y = 0.0;
    for (auto k = m.network.corner_start[d]; k < m.network.corner_start[d + 1]; ++k) {
      x += m.network.corner_weight[2 * k];
      y += m.network.corner_weight[2 * k + 1];
    }
    EXPECT_NEAR(x, 0.0, 1e-12) << "domain " << d;
    EXPECT_NEAR(y, 0.0, 1e-12) << "domain " << d;
  }
}

TEST(Network, VolumeChangeIsThatOfThePolygonWhenRadiiAreEqual) {
  Options o = wet_options();
  o.packing_radius_ratio = 1.0;
  TestModel m(o, packed(o));
  std::vector<double> before;
  for (std::int64_t d = 0; d < m.network.domain_count(); ++d) before.push_back(polygon_area(m, d));
  constexpr double size = 1e-6;
  m.shake(size, 3);
  m.fill_pores();
  m.solver->evaluate();
  const double radius = m.assembly.mean_radius;
  for (std::int64_t d = 1; d < m.network.domain_count(); ++d) {
    const auto corners = m.network.corner_start[d + 1] - m.network.corner_start[d];
    // What is left is of second order in the displacement.
    EXPECT_NEAR(m.network.volume_change[d], polygon_area(m, d) - before[d],
                10.0 * corners * size * size * radius * radius)
        << "domain " << d;
    EXPECT_NEAR(m.network.pressure[d],
                m.network.reference_pressure - m.network.stiffness[d] * m.network.volume_change[d], 1e-6);
  }
}

TEST(Network, VolumesArePolygonLessDiscs) {
  const Options o = wet_options();
  const TestModel lattice(o, square_lattice(5, 5, 0.5));
  for (std::int64_t d = 1; d < lattice.network.domain_count(); ++d) {
    EXPECT_NEAR(lattice.network.volume[d], 1.0 - 0.25 * pi, 1e-12);
  }
  const Discs discs = packed(o);
  const TestModel m(o, discs);
  double pores = 0.0, outline = 0.0;
  for (std::int64_t d = 1; d < m.network.domain_count(); ++d) {
    EXPECT_GT(m.network.volume[d], 0.0);
    pores += m.network.volume[d];
    outline += m.faces.polygon_area[d];
  }
  // Porosity of the packing, raised by the floaters taken out and the thin pores rounded up.
  EXPECT_GT(pores / outline, 0.10);
  EXPECT_LT(pores / outline, 0.22);
}

TEST(Network, ConventionSetsReferenceAndFloor) {
  Options o = wet_options();
  const Discs discs = square_lattice(5, 5, 0.5);
  const TestModel sound(o, discs);
  EXPECT_EQ(sound.network.reference_pressure, 25e6);
  EXPECT_EQ(sound.network.floor_pressure, 0.0);
  o.stress_convention = choice(StressConvention::effective);
  const TestModel paper(o, discs);
  EXPECT_EQ(paper.network.reference_pressure, 0.0);
  EXPECT_EQ(paper.network.floor_pressure, -25e6);
}

}  // namespace network_test
