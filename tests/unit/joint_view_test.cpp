// SPDX-License-Identifier: BSD-3-Clause
// What is seen of a joint's contacts under a known normal stress and shear: closure by Bandis, aperture by its law, slip and its sign,
// state, pressure, place.
#include "flow/joint_view.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "flow/aperture.hpp"
#include "model.hpp"
#include "model/joint_pores.hpp"
#include "solid/joints.hpp"
#include "solid/smooth_joints.hpp"

namespace joint_view_test {

using namespace testing_unit;

// A block cut by a joint at 30 degrees; what lies on its left moves as one.
struct Block {
  Options o = dry_options(500);
  JointOptions joint;
  Assembly a;
  Network n;
  CrackLog cracks;
  Vec2 along{std::cos(pi / 6.0), std::sin(pi / 6.0)}, normal{-along.y, along.x};

  explicit Block(JointState state) {
    o.flow_scheme = choice(FlowScheme::implicit_scheme);
    o.flow_aperture_limit = 0.01;
    const Discs discs = packed(o);
    ContactGraph graph = build_contact_graph(discs.x, discs.y, discs.radius, {}, o.bond_gap_tolerance);
    Faces faces = build_faces(graph);
    joint.x1 = 10.0 - 15.0 * along.x;
    joint.y1 = 10.0 - 15.0 * along.y;
    joint.x2 = 10.0 + 15.0 * along.x;
    joint.y2 = 10.0 + 15.0 * along.y;
    joint.state = static_cast<std::int64_t>(state);
    joint.friction = 0.6;
    joint.normal_stiffness = 2e10;
    joint.shear_stiffness = 1e10;
    joint.max_closure = 1e-4;
    joint.aperture = 1.5e-4;
    joint.roughness = 10.0;
    o.stress_sigma_Hmax = o.stress_sigma_hmin = 30e6;
    a = build_assembly(std::move(graph), o);
    apply_joints(a, {joint}, o, cracks);
    n = build_network(std::move(faces), a, {}, o);
    begin_joint_pores(n, a, o);
  }

  // Pressed together by `press` and moved by `slide` along the joint [m].
  void move(double press, double slide) {
    const Vec2 by = slide * along - press * normal;
    for (std::int32_t i = 0; i < a.disc_count(); ++i) {
      const bool above = cross(along, Vec2{a.x[i] - joint.x1, a.y[i] - joint.y1}) > 0.0;
      const bool left = above != (a.smooth.moved_over(i) >= 0);
      a.ux[i] = left ? by.x : 0.0;
      a.uy[i] = left ? by.y : 0.0;
    }
    double friction = 0.0;
    for (const auto& contact : a.smooth.contacts) answer_of(a, contact, a.slip[contact.bond], friction);
    update_apertures(n, a, o);
  }

  template <class Check>
  void each(const Check& check) {
    EXPECT_GT(a.smooth.contacts.size(), 10U);
    for (const auto& contact : a.smooth.contacts) check(contact, view_joint(a, n, contact));
  }
};

constexpr double press = 0.5e-4;  // half of the largest closure, at which it bears k_n d_m = 2 MPa

TEST(JointView, SticksAndClosesByBandis) {
  Block block(JointState::smooth_broken);
  block.move(press, 1e-5);
  const double e_in_micrometres = 100.0;  // 150 - 50, and JRC 10
  block.each([&](const SmoothContact&, const JointView& v) {
    EXPECT_NEAR(v.opening, -press, 1e-12);
    EXPECT_NEAR(v.mechanical_aperture, 1e-4, 1e-12);
    EXPECT_NEAR(v.hydraulic_aperture, e_in_micrometres * e_in_micrometres / std::pow(10.0, 2.5) * 1e-6,
                1e-12);
    EXPECT_NEAR(v.normal_stress, 2e6, 1.0);
    EXPECT_NEAR(v.shear_stress, -1e10 * 1e-5, 1.0);  // the left half moved to the right, seen from the other
    EXPECT_EQ(v.slip, 0.0);
    EXPECT_EQ(v.state, JointContactState::sticks);
  });
}

TEST(JointView, SlipsByWhatFrictionDoesNotBear) {
  for (const double side : {1.0, -1.0}) {
    Block block(JointState::smooth_broken);
    block.move(press, side * 5e-3);
    block.each([&](const SmoothContact&, const JointView& v) {
      EXPECT_NEAR(v.shear_stress, -side * 0.6 * 2e6, 1.0);
      EXPECT_NEAR(v.slip, -side * (5e-3 - 0.6 * 2e6 / 1e10), 1e-12);
      EXPECT_EQ(v.state, JointContactState::slips);
    });
    block.move(press, side * (5e-3 - 1e-5));  // back a little: it bears less than friction could
    block.each([&](const SmoothContact&, const JointView& v) {
      EXPECT_NEAR(v.shear_stress, -side * (0.6 * 2e6 - 1e5), 1.0);
      EXPECT_EQ(v.state, JointContactState::sticks);
    });
  }
}

TEST(JointView, IsOpenWhereItsFacesBearNothingAndHoldsInTension) {
  Block block(JointState::smooth_broken);
  block.move(-1e-3, 0.0);
  block.each([](const SmoothContact&, const JointView& v) {
    EXPECT_EQ(v.state, JointContactState::open);
    EXPECT_EQ(v.normal_stress, 0.0);
    EXPECT_NEAR(v.mechanical_aperture, 1.15e-3, 1e-12);
    EXPECT_NEAR(v.hydraulic_aperture, 1.15e-3, 1e-12);  // beyond J^2.5 micrometres it is as open as its faces
  });
  Block whole(JointState::smooth_bonded);
  whole.move(-1e-5, 0.0);
  whole.each([](const SmoothContact&, const JointView& v) {
    EXPECT_EQ(v.state, JointContactState::holds);
    EXPECT_NEAR(v.normal_stress, -2e10 * 1e-5, 1.0);
  });
}

TEST(JointView, LiesOnItsJointAndHasThePressureBesideIt) {
  Block block(JointState::smooth_broken);
  block.move(press, 0.0);
  for (std::int64_t d = 0; d < block.n.domain_count(); ++d)
    block.n.pressure[d] = 1e5 * static_cast<double>(d);
  double length = 0.0;
  block.each([&](const SmoothContact& contact, const JointView& v) {
    const Vec2 way = v.end - v.begin, middle = 0.5 * (v.begin + v.end);
    length += std::sqrt(dot(way, way));
    EXPECT_NEAR(std::sqrt(dot(way, way)), contact.area, 1e-12);
    EXPECT_NEAR(cross(way, block.along), 0.0, 1e-12);
    EXPECT_NEAR(dot(middle - Vec2{block.joint.x1, block.joint.y1}, block.normal), -0.5 * press, 1e-9);
    const auto e = static_cast<std::size_t>(contact.bond);
    EXPECT_DOUBLE_EQ(v.pressure, 0.5e5 * (block.n.left[e] + block.n.right[e]));
  });
  EXPECT_NEAR(length, 20.0 / block.along.x, 3.0 * block.a.mean_radius);
}

}  // namespace joint_view_test
