// SPDX-License-Identifier: BSD-3-Clause
// A joint's law: closure, friction, dilation, aperture, and what the contact and its pores make of them.
#include "model/joint_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "equilibrium/bond_response.hpp"
#include "small_case.hpp"
#include "solid/joints.hpp"
#include "solid/smooth_joints.hpp"
#include "tangent_check.hpp"

namespace joint_law_test {

using namespace testing_unit;

JointLaw granite_joint() {
  JointLaw law;
  law.normal_stiffness = 2e10;
  law.shear_stiffness = 1e10;
  law.max_closure = 1e-4;
  law.highest = 60e6;
  law.residual_friction = 0.3;
  law.weakening_slip = 5e-3;
  law.dilation = std::tan(0.1);
  law.dilation_slip = 2e-3;
  law.aperture = 1.5e-4;
  return law;
}

// Bandis, Lumsden and Barton 1983: half of the largest closure takes k_n d_m.
TEST(JointLaw, ClosesByBandis) {
  JointLaw law = granite_joint();
  EXPECT_NEAR(closure_stress(law, 0.5e-4).value, 2e10 * 1e-4, 1.0);
  EXPECT_NEAR(closure_stress(law, 0.5e-4).slope, 4.0 * 2e10, 1e-3);
  EXPECT_EQ(closure_stress(law, -1e-5).value, 0.0);
  const double last = 60e6 / (2e10 + 60e6 / 1e-4);
  EXPECT_NEAR(closure_stress(law, last).value, 60e6, 1e-3);
  EXPECT_NEAR(closure_stress(law, last + 1e-6).value, 60e6 + 1e-6 * stiffest(law), 1.0);
  for (const double d : {1e-6, 3e-5, 0.7e-4, 1.1e-4}) {  // energy is the integral, slope the change
    const double step = 1e-9;
    const double by_energy = (closure_energy(law, d + step) - closure_energy(law, d - step)) / (2.0 * step);
    EXPECT_NEAR(by_energy, closure_stress(law, d).value, 1e-4 * closure_stress(law, d).value + 1.0) << d;
    const double by_stress =
        (closure_stress(law, d + step).value - closure_stress(law, d - step).value) / (2.0 * step);
    EXPECT_NEAR(by_stress, closure_stress(law, d).slope, 1e-3 * by_stress) << d;
  }
  law.max_closure = 0.0;
  EXPECT_EQ(closure_stress(law, 1e-3).value, 2e7);
}

TEST(JointLaw, WeakensAndDilatesUntilTheSlipsGiven) {
  const JointLaw law = granite_joint();
  EXPECT_DOUBLE_EQ(joint_friction(law, 0.7, 0.0).value, 0.7);
  EXPECT_DOUBLE_EQ(joint_friction(law, 0.7, -2.5e-3).value, 0.5);
  EXPECT_DOUBLE_EQ(joint_friction(law, 0.7, 9.0).value, 0.3);
  EXPECT_DOUBLE_EQ(joint_dilation(law, -1e-3).value, 1e-3 * std::tan(0.1));
  EXPECT_DOUBLE_EQ(joint_dilation(law, 5e-3).value, 2e-3 * std::tan(0.1));
  EXPECT_EQ(joint_dilation(law, 5e-3).slope, 0.0);
}

// Barton, Bandis and Bakhtar 1985: e = 100 um and JRC 10 conduct as 100^2 / 10^2.5 = 31.6 um; wide joints as they are open.
TEST(JointLaw, ConductsLessThanItIsOpenWhereItIsRough) {
  JointLaw law;
  law.aperture = 150e-6;
  law.roughness = 10.0;
  EXPECT_NEAR(joint_aperture(law, -50e-6).value, 31.62e-6, 0.01e-6);
  EXPECT_DOUBLE_EQ(joint_aperture(law, 850e-6).value, 1e-3);
  law.residual_aperture = 5e-6;
  EXPECT_DOUBLE_EQ(joint_aperture(law, -1.0).value, 5e-6);
  EXPECT_EQ(joint_aperture(law, -1.0).slope, 0.0);
}

struct Contact {
  Options o = dry_options(500);
  Assembly a;
  CrackLog cracks;
  JointOptions joint;
  Contact() {
    const Discs discs = packed(o);
    ContactGraph graph = build_contact_graph(discs.x, discs.y, discs.radius, {}, o.bond_gap_tolerance);
    joint.x1 = -5.0;
    joint.y1 = 4.0;
    joint.x2 = 25.0;
    joint.y2 = 15.0;
    joint.friction = 0.6;
    joint.state = static_cast<std::int64_t>(JointState::smooth_broken);
    joint.normal_stiffness = 2e10;
    joint.shear_stiffness = 1e10;
    joint.max_closure = 1e-4;
    joint.residual_friction = 0.3;
    joint.weakening_slip = 0.05;
    joint.dilation_angle = 0.1;
    joint.dilation_slip = 2e-3;
    o.stress_sigma_Hmax = o.stress_sigma_hmin = 30e6;
    a = build_assembly(std::move(graph), o);
    apply_joints(a, {joint}, o, cracks);
  }
};

TEST(JointLaw, TangentOfAContactIsTheChangeOfItsForce) {
  for (const double press : {6e-5, 2e-5, -1e-5}) {
    for (const double slide :
         {1e-5, 5e-4, -5e-4, 4e-3}) {  // sticking, dilating to either side, dilation ended
      Contact c;
      const SmoothContact& contact = c.a.smooth.contacts[3];
      const auto i = c.a.first[contact.bond], j = c.a.second[contact.bond];
      const Vec2 n = contact.normal, move = -press * n + slide * Vec2{-n.y, n.x};
      c.a.ux[j] = move.x;
      c.a.uy[j] = move.y;
      c.a.rotation[i] = 1e-6;
      expect_tangent(c.a, c.o, contact.bond, 1e-10, 1e-3 * 2e10);
    }
  }
}

// Held against the normal, a joint that slips is pressed together by what it would dilate; what it bears in shear is mu times that.
TEST(JointLaw, DilationPressesAJointThatIsHeld) {
  Contact c;
  const SmoothContact& contact = c.a.smooth.contacts[3];
  const auto j = c.a.second[contact.bond];
  const Vec2 n = contact.normal, move = -3e-5 * n + 4e-4 * Vec2{-n.y, n.x};
  const double before = -smooth_response(c.a, contact).normal;
  EXPECT_EQ(before, 0.0);
  c.a.ux[j] = move.x;
  c.a.uy[j] = move.y;
  const SmoothResponse r = smooth_response(c.a, contact);
  const JointLaw& law = c.a.smooth.law_of(contact);
  const double lifted = std::tan(0.1) * r.slipped;
  EXPECT_GT(r.slipped, 2e-4);
  EXPECT_NEAR(-r.normal, contact.area * closure_stress(law, 3e-5 + lifted).value, -1e-9 * r.normal);
  const double mu = 0.6 + (0.3 - 0.6) / 0.05 * r.slipped;
  EXPECT_NEAR(r.shear, -mu * r.normal, -1e-9 * r.normal);
  EXPECT_NEAR(r.shear, contact.area * law.shear_stiffness * (4e-4 - r.slipped), 1e-9 * r.shear);
}

}  // namespace joint_law_test
