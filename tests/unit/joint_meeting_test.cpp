// SPDX-License-Identifier: BSD-3-Clause
// Where joints meet: fluid passes along joints from one to the other, at a crossing, and at an end that lies on another joint or short
// of it by less than a disc.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "build/build_model.hpp"
#include "model/joint_pores.hpp"
#include "small_case.hpp"

namespace joint_meeting_test {

using namespace testing_unit;

JointOptions conducting(Vec2 from, Vec2 to) {
  JointOptions joint;
  joint.x1 = from.x;
  joint.y1 = from.y;
  joint.x2 = to.x;
  joint.y2 = to.y;
  joint.state = static_cast<std::int64_t>(JointState::smooth_broken);
  joint.aperture = 1e-3;
  return joint;
}

class JointMeeting : public testing::Test {
 protected:
  void SetUp() override {
    definition_ = quiet_case();
    definition_.wells.clear();
    definition_.options.packing_disc_count = 1000;
    SetupReport report;
    packing_ = take_discs(definition_, {}, {}, report);
    mean_radius_ = expected_mean_radius(definition_.options);
  }

  // Whether the joints' own pipes lead from one to the other.
  bool meet(const JointOptions& one, const JointOptions& other) {
    definition_.joints = {one, other};
    SetupReport report;
    const Model model = build_model(definition_, packing_, {}, report);
    EXPECT_EQ(report.joints_left_out, 0);
    const Network& n = model.network;
    std::vector<std::int32_t> root(n.kind.size());
    std::iota(root.begin(), root.end(), 0);
    const auto top = [&](std::int32_t d) {
      while (root[static_cast<std::size_t>(d)] != d) d = root[static_cast<std::size_t>(d)];
      return d;
    };
    for (std::size_t e = 0; e < n.left.size(); ++e)
      if (joint_length(n, e) > 0.0) root[static_cast<std::size_t>(top(n.left[e]))] = top(n.right[e]);
    std::int32_t first = -1, second = -1;
    for (const auto& c : model.assembly.smooth.contacts)
      (c.joint == 0 ? first : second) = top(n.left[c.bond]);
    return first >= 0 && first == second;
  }

  // Of joints that end beside a long one, `gap` mean radii short of it (negative: beyond), how many of 40 meet it.
  int met_by_ends(double gap) {
    const JointOptions along = conducting({5.0, 48.0}, {95.0, 53.0});
    const Vec2 way{90.0, 5.0};
    int met = 0;
    for (int k = 0; k < 40; ++k) {
      const double share = 0.15 + 0.7 * k / 39.0, angle = (30.0 + 7.0 * (k % 18)) * std::numbers::pi / 180.0;
      const Vec2 dir{std::cos(angle), std::sin(angle)}, at{5.0 + share * way.x, 48.0 + share * way.y};
      const double across = cross(way, dir) / std::sqrt(dot(way, way));  // sine between the two
      const Vec2 end = at + (gap * mean_radius_ / across) * dir;
      met += meet(along, conducting(end + 25.0 * dir, end)) ? 1 : 0;
    }
    return met;
  }

  CaseDefinition definition_;
  Packing packing_;
  double mean_radius_ = 0.0;
};

TEST_F(JointMeeting, AtACrossing) {
  EXPECT_EQ(met_by_ends(-3.0), 40);
}

// A T end, to the hair that a file's digits leave.
TEST_F(JointMeeting, AtAnEndOnAnotherJoint) {
  for (const double gap : {-1e-3, 0.0, 1e-3, 0.1}) EXPECT_EQ(met_by_ends(gap), 40) << gap;
}

// Farther off the packing decides: discs are the model's resolution.
TEST_F(JointMeeting, NotAcrossDiscsOfRock) {
  EXPECT_GT(met_by_ends(1.0), 20);
  EXPECT_LT(met_by_ends(2.0), 20);
  EXPECT_EQ(met_by_ends(4.0), 0);
}

}  // namespace joint_meeting_test
