// SPDX-License-Identifier: BSD-3-Clause
// What holds the model from outside: stress on the outermost discs, or four walls with a servo.
#include "solid/boundary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model.hpp"

namespace boundary_test {

using namespace testing_unit;

struct Resultant {
  double fx = 0.0, fy = 0.0, torque = 0.0, size = 0.0;
};

Resultant resultant(const Assembly& a) {
  Resultant r;
  for (std::int64_t i = 0; i < a.disc_count(); ++i) {
    r.fx += a.external_x[i];
    r.fy += a.external_y[i];
    r.torque += cross({a.x[i], a.y[i]}, {a.external_x[i], a.external_y[i]});
    r.size += std::abs(a.external_x[i]) + std::abs(a.external_y[i]);
  }
  return r;
}

TEST(StressBoundary, HasNoNetForce) {
  Options o = dry_options(500);
  o.stress_sigma_Hmax = 3e7;
  o.stress_sigma_hmin = 1e7;
  TestModel m(o, packed(o), {{{10.0, 10.0}, 3.0}});
  m.boundary->set_load(m.assembly, 1.0);
  const Resultant r = resultant(m.assembly);
  EXPECT_GT(r.size, 0.0);
  EXPECT_LT(std::abs(r.fx), 1e-13 * r.size);
  EXPECT_LT(std::abs(r.fy), 1e-13 * r.size);
  EXPECT_FALSE(m.boundary->walled());
  EXPECT_FALSE(m.boundary->walled());
}

TEST(StressBoundary, HasNoNetTorque) {
  // physics.md 5: "stress times length, split by radii, give zero net force and torque exactly".
  for (const double smaller : {3e7, 1e7}) {
    Options o = dry_options(500);
    o.stress_sigma_Hmax = 3e7;
    o.stress_sigma_hmin = smaller;
    TestModel m(o, packed(o));
    m.boundary->set_load(m.assembly, 1.0);
    const Resultant r = resultant(m.assembly);
    const double relative = std::abs(r.torque) / (r.size * o.model_width);
    RecordProperty(smaller == 3e7 ? "hydrostatic" : "deviatoric", std::to_string(relative));
    EXPECT_LT(relative, 1e-10) << "sigma_hmin " << smaller;
  }
}

TEST(StressBoundary, CarriesStressTimesLength) {
  Options o = dry_options(500);
  o.stress_sigma_Hmax = 3e7;
  o.stress_sigma_hmin = 1e7;
  TestModel m(o, square_lattice(12, 10, 0.5));
  m.boundary->set_load(m.assembly, 0.5);
  double west = 0.0, south = 0.0;
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
    if (m.assembly.external_x[i] > 0.0) west += m.assembly.external_x[i];
    if (m.assembly.external_y[i] > 0.0) south += m.assembly.external_y[i];
  }
  EXPECT_NEAR(west, 0.5 * 3e7 * 9.0, 1.0);  // nine metres between the outermost centres
  EXPECT_NEAR(south, 0.5 * 1e7 * 11.0, 1.0);
}

TEST(StressBoundary, DoesNotTurnTheBody) {
  // A body held by constant loads alone is free to turn; it must stay put over many steps.
  Options o = dry_options(500);
  o.stress_sigma_Hmax = 4e7;
  o.stress_sigma_hmin = 3e7;
  TestModel m(o, packed(o));
  m.boundary->set_load(m.assembly, 1.0);
  CrackLog log;
  ASSERT_TRUE(m.solver->relax(1e-4, 50000, log).at_rest);
  const auto turn = [&] {
    double moment = 0.0, inertia = 0.0;
    for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
      const Vec2 from = Vec2{m.assembly.x[i], m.assembly.y[i]} - Vec2{10.0, 10.0};
      moment += cross(from, {m.assembly.ux[i], m.assembly.uy[i]});
      inertia += dot(from, from);
    }
    return moment / inertia;
  };
  const double before = turn();
  m.solver->run(50000, log);
  const double after = turn();
  RecordProperty("turn_before", std::to_string(before));
  RecordProperty("turn_after", std::to_string(after));
  EXPECT_LT(std::abs(after), 1e-3) << "turned by " << after << " rad in 50 000 cycles, " << before
                                   << " at first rest";
}

TEST(Walls, ServoReachesItsStress) {
  for (const double smaller : {2e7, 0.5e7}) {
    Options o = dry_options(500);
    o.boundary_kind = choice(BoundaryKind::walls);
    o.stress_convention = choice(StressConvention::effective);
    o.stress_sigma_Hmax = 2e7;
    o.stress_sigma_hmin = smaller;
    TestModel m(o, packed(o));
    EXPECT_TRUE(m.boundary->walled());
    m.boundary->set_load(m.assembly, 1.0);
    CrackLog log;
    const auto outcome = m.solver->relax(1e-4, 200000, log);
    EXPECT_TRUE(outcome.at_rest);
    EXPECT_LE(m.boundary->wall_imbalance(), 1e-4);
    const Vec2 stress = m.boundary->wall_stress(m.assembly);
    EXPECT_NEAR(stress.x, 2e7, 1e-3 * 2e7);
    EXPECT_NEAR(stress.y, smaller, 1e-3 * smaller);
    // Fixed, they stay where they are.
    m.boundary->fix_walls();
    const double at = m.boundary->walls()[0].displacement;
    m.solver->run(100, log);
    EXPECT_EQ(m.boundary->walls()[0].displacement, at);
    EXPECT_EQ(m.boundary->wall_imbalance(), 0.0);
  }
}

TEST(Walls, PushButNeverPull) {
  Options o = dry_options(500);
  o.boundary_kind = choice(BoundaryKind::walls);
  o.stress_convention = choice(StressConvention::effective);
  TestModel m(o, packed(o));
  m.boundary->fix_walls();
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) m.assembly.ux[i] = 0.01;
  m.boundary->cycle(m.assembly, 1.0, 0.8, 0.0);
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) EXPECT_LE(m.assembly.external_x[i], 0.0);
  EXPECT_NEAR(
      m.boundary->wall_energy(m.assembly),
      0.5 * o.contact_normal_stiffness * 1e-4 * static_cast<double>(m.boundary->walls()[1].discs.size()),
      1e-3);
}

TEST(Walls, OfADryRockCarryTheWholeStress) {
  // Without pores nothing but the walls can carry a total far-field stress.
  Options o = dry_options(500);
  o.boundary_kind = choice(BoundaryKind::walls);
  o.stress_sigma_Hmax = o.stress_sigma_hmin = 4e7;
  const TestModel m(o, packed(o));
  EXPECT_EQ(m.boundary->walls()[0].target, 4e7);
}

}  // namespace boundary_test
