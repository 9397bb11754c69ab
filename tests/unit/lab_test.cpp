// SPDX-License-Identifier: BSD-3-Clause
// Specimens on the bench: what is held, loaded and cut is what was asked for.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "lab/crack_tests.hpp"
#include "lab/laboratory.hpp"
#include "model.hpp"

namespace lab_test {

using namespace testing_unit;

Options linear() {
  Options o;
  o.contact_mode = choice(ContactMode::after_break);
  o.bond_normal_stiffness = 16e9;
  o.bond_shear_stiffness = 5.6e9;
  return o;
}

LabSpec spec_of(LabTest test, std::int64_t discs) {
  LabSpec spec;
  spec.test = test;
  spec.discs = discs;
  return spec;
}

TEST(Lab, ALinearRockIsOneFactor) {
  const auto r = run_lab(linear(), spec_of(LabTest::elastic, 1000)).report;
  EXPECT_EQ(r.factors, 1);
  EXPECT_EQ(r.relaxations, 0);
  EXPECT_LT(r.force_ratio, 1e-6);
  EXPECT_NEAR(r.plane_modulus, 14.2e9, 0.07 * 14.2e9);  // V2
  EXPECT_NEAR(r.poisson, r.plane_poisson / (1.0 + r.plane_poisson), 1e-12);
}

TEST(Lab, ElasticityIsProportionalToStiffnessAndBlindToSize) {
  Options o = linear();
  const auto first = run_lab(o, spec_of(LabTest::elastic, 500)).report;
  o.bond_normal_stiffness *= 2.0;
  o.bond_shear_stiffness *= 2.0;
  o.contact_normal_stiffness *= 2.0;
  LabSpec larger = spec_of(LabTest::elastic, 500);
  larger.width = 1000.0;
  const auto second = run_lab(o, larger).report;
  EXPECT_NEAR(second.plane_modulus / first.plane_modulus, 2.0, 1e-4);
  EXPECT_NEAR(second.plane_poisson, first.plane_poisson, 1e-4);
}

TEST(Lab, PlatensPullAsHardAsASectionBears) {
  // Equilibrium: the force through every section is the platens' own; in the middle it is the sum over the bonds cut there.
  const Options o = linear();
  const Packing packing = pack_specimen(o, LabTest::tension, 10.0, 400, 1);
  Specimen s(packing, o, SpecimenShape{.width = 10.0, .height = 20.0});
  s.grip_ends();
  s.make_unbreakable();
  s.lead_ends(1e-3);
  ASSERT_EQ(s.solve(1e300).end, EquilibriumSolver::End::rest);
  double through = 0.0;
  const auto& a = s.assembly();
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    const double y1 = a.y[a.first[e]] - 10.0, y2 = a.y[a.second[e]] - 10.0;
    if (y1 * y2 >= 0.0) continue;
    const BondView b = view_bond(a, s.options(), e);
    const double up = b.normal_force() * b.normal.y + b.shear_force() * b.normal.x;
    through += y2 > y1 ? up : -up;
  }
  EXPECT_NEAR(s.pull() / through, 1.0, 1e-3);
}

TEST(Lab, ASlitBearsNothingAndOpens) {
  const Options o = linear();
  const Packing packing = pack_specimen(o, LabTest::centre_crack, 10.0, 800, 1);
  Specimen s(
      packing, o,
      SpecimenShape{.width = 10.0, .height = 15.0, .slit_begin = 3.5, .slit_end = 6.5, .stress_y = -1e6});
  s.load_sides(1.0);
  ASSERT_EQ(s.solve(1e300).end, EquilibriumSolver::End::rest);
  EXPECT_NEAR(s.tips().x, 3.5, 0.5);
  EXPECT_NEAR(s.tips().y, 6.5, 0.5);
  for (const Vec2& point : s.opening()) EXPECT_GT(point.y, 0.0);
  EXPECT_TRUE(s.cracks().empty());
}

TEST(Lab, GeometryFactorsAreTheHandbooks) {
  // Tada, Paris and Irwin: narrow slits; 1.0246 at 2 a / W = 0.2; 1.12 of an edge crack, 1.6599 at a / W = 0.3.
  EXPECT_NEAR(crack_geometry_factor(LabTest::centre_crack, 1e-6), 1.0, 1e-6);
  EXPECT_NEAR(crack_geometry_factor(LabTest::centre_crack, 0.2), 1.0246, 2e-3);
  EXPECT_NEAR(crack_geometry_factor(LabTest::sent, 1e-6), 1.122, 1e-3);
  EXPECT_NEAR(crack_geometry_factor(LabTest::sent, 0.3), 1.66, 1e-2);
}

TEST(Lab, StrengthGoesWithTheBonds) {
  Options o;
  const auto first = run_lab(o, spec_of(LabTest::tension, 500)).report;
  o.bond_tensile_strength *= 0.5;
  o.bond_shear_strength *= 0.5;
  const auto second = run_lab(o, spec_of(LabTest::tension, 500)).report;
  EXPECT_EQ(first.end, TestEnd::failed);
  EXPECT_LT(first.worst_overshoot, 0.011);
  EXPECT_NEAR(second.value / first.value, 0.5, 0.01);
}

TEST(Lab, ConfinementStrengthens) {
  LabSpec spec = spec_of(LabTest::biaxial, 400);
  const double free = run_lab(Options{}, spec).report.value;
  spec.confining = 10e6;
  EXPECT_GT(run_lab(Options{}, spec).report.value, free + 10e6);
}

TEST(Lab, ASpecimenTooCoarseForItsSlitIsRefused) {
  LabSpec spec = spec_of(LabTest::centre_crack, 100);
  spec.slit_fraction = 0.05;
  EXPECT_THROW(run_lab(linear(), spec), Error);
}

}  // namespace lab_test
