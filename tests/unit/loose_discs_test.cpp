// SPDX-License-Identifier: BSD-3-Clause
// Discs that lost their bonds: which bonds joints leave to what they cut off, and that discs gain no energy by being looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "build/build_model.hpp"
#include "small_case.hpp"
#include "solid/discs_held.hpp"
#include "solid/non_bonded_contacts.hpp"

namespace loose_discs_test {

using namespace testing_unit;

class LooseDiscs : public testing::Test {
 protected:
  LooseDiscs() : sim_(quiet_case(), {}, {}), a_(sim_.engine().model.assembly) {
    // Away from the well and the edge.
    double least = 1e300;
    for (std::int32_t i = 0; i < a_.disc_count(); ++i) {
      const double off = std::hypot(a_.x[i] - 25.0, a_.y[i] - 25.0);
      if (off < least) disc_ = i;
      least = std::min(least, off);
    }
  }

  [[nodiscard]] bool at(std::int64_t bond, std::int32_t disc) const {
    return a_.first[bond] == disc || a_.second[bond] == disc;
  }

  // What is left to the rock where smooth joints cross the bonds that `cut` gives a joint's number.
  template <class Cut>
  [[nodiscard]] std::vector<KeptBond> kept(const Cut& cut) {
    JointOptions joint;
    joint.state = static_cast<std::int64_t>(JointState::smooth_broken);
    joint_of_.clear();
    for (std::int64_t e = 0; e < a_.bond_count(); ++e) joint_of_.push_back(cut(e));
    HeldDiscs held = keep_discs_held(a_, {joint, joint}, joint_of_);
    moved_ = held.moved;
    return held.kept;
  }

  Simulation sim_;
  Assembly& a_;
  std::int32_t disc_ = 0;
  std::vector<std::int32_t> joint_of_;
  std::vector<MovedDisc> moved_;
};

TEST_F(LooseDiscs, OneThatASingleJointCutsOffKeepsTwoBonds) {
  const auto left = kept([&](std::int64_t e) { return at(e, disc_) ? 0 : -1; });
  ASSERT_EQ(left.size(), 2U);
  for (const auto& bond : left) {
    EXPECT_TRUE(at(bond.bond, disc_));
    EXPECT_EQ(bond.joint, 0);
    EXPECT_EQ(joint_of_[static_cast<std::size_t>(bond.bond)], -1);
  }
  ASSERT_EQ(moved_.size(), 1U);
  EXPECT_EQ(moved_[0].disc, disc_);
}

// At a hole's wall one that a joint leaves with a single bond goes, and then those that it held: basel-stiff.toml in packing 3 had a chain of two,
// which broke off as the far field came, opened the joint by a tenth of a metre and sucked at its own well.
TEST(FallenDiscs, AreGoneFromTheHolesWall) {
  CaseDefinition c = quiet_case();
  JointOptions joint;
  joint.x1 = 10.0, joint.y1 = 42.0;
  joint.x2 = 90.0, joint.y2 = 67.0;
  joint.state = static_cast<std::int64_t>(JointState::smooth_broken);
  std::int64_t fallen = 0;
  for (int seed = 1; seed <= 10; ++seed) {
    c.options.model_seed = seed;
    SetupReport without, with;
    c.joints.clear();
    (void)build_model(c, take_discs(c, {}, {}, without), {}, without);
    c.joints = {joint};
    const Model m = build_model(c, take_discs(c, {}, {}, with), {}, with);
    const Assembly& a = m.assembly;
    EXPECT_EQ(with.removed_in_wells, without.removed_in_wells);
    EXPECT_EQ(a.disc_count(), with.packed - with.removed_in_wells - with.removed_floaters);
    EXPECT_EQ(static_cast<std::int64_t>(m.cracks.size()), std::count(a.intact.begin(), a.intact.end(), 0));
    fallen += with.removed_floaters - without.removed_floaters;
    // Beside the well are the discs of its pipes.
    std::vector<int> held(static_cast<std::size_t>(a.disc_count()));
    std::vector<char> wall(held.size());
    for (std::int64_t e = 0; e < a.bond_count(); ++e) {
      const auto well = m.wells[0].place.domain;
      for (const auto i : {a.first[e], a.second[e]}) {
        held[static_cast<std::size_t>(i)] += a.intact[e] != 0 ? 1 : 0;
        if (m.network.left[static_cast<std::size_t>(e)] == well ||
            m.network.right[static_cast<std::size_t>(e)] == well)
          wall[static_cast<std::size_t>(i)] = 1;
      }
    }
    for (std::size_t i = 0; i < held.size(); ++i)
      EXPECT_TRUE(wall[i] == 0 || held[i] >= 2) << "seed " << seed << ", disc " << i;
  }
  EXPECT_GT(fallen, 0) << "no packing puts what is tested to the test";
}

// It slides with the other side, so what it comes to on its own side is across the joint, and bears on contacts of the joint alone: before
// that was so, one such disc held a joint through a block at 1.7 times the load at which it slips (V21, 50 degrees).
TEST(MovedDiscs, AreOnTheOtherSideOfTheirJoint) {
  SmoothJoints joints;
  joints.lines = {{{-10.0, 0.0}, {10.0, 0.0}}, {{5.0, -3.0}, {5.0, 3.0}}};
  joints.sort_lines(1.0);
  const Vec2 own{0.0, 0.5}, beside{1.0, 0.6}, across{0.5, -0.5}, beyond{4.5, -0.4}, farther{5.5, -0.4};
  EXPECT_FALSE(joints.separate(7, own, 8, beside));
  EXPECT_TRUE(joints.separate(7, own, 8, across));
  joints.moved = {{7, 0}};
  EXPECT_TRUE(joints.separate(7, own, 8, beside));
  EXPECT_TRUE(joints.separate(8, beside, 7, own));
  EXPECT_FALSE(joints.separate(7, own, 8, across));
  EXPECT_TRUE(joints.separate(8, beside, 9, across));
  EXPECT_FALSE(joints.separate(7, own, 8, beyond));
  EXPECT_TRUE(joints.separate(7, own, 8, farther));  // another joint lies between
}

TEST_F(LooseDiscs, TwoThatHangTogetherKeepTwoBondsBetweenThem) {
  std::int32_t other = -1;
  for (std::int64_t e = 0; e < a_.bond_count() && other < 0; ++e)
    if (at(e, disc_)) other = a_.first[e] == disc_ ? a_.second[e] : a_.first[e];
  const auto left = kept([&](std::int64_t e) { return at(e, disc_) != at(e, other) ? 0 : -1; });
  EXPECT_EQ(left.size(), 2U);
}

TEST_F(LooseDiscs, OneThatJointsHoldByASingleBondKeepsASecond) {
  std::int64_t spared = -1;
  std::int32_t turn = 0;
  const auto left = kept([&](std::int64_t e) {
    if (!at(e, disc_)) return -1;
    if (spared < 0) spared = e;
    return e == spared ? -1 : turn++ % 2;
  });
  EXPECT_EQ(left.size(), 1U);
}

TEST_F(LooseDiscs, PiecesOfRockKeepNone) {
  const auto left = kept(
      [&](std::int64_t e) { return (a_.x[a_.first[e]] < 25.0) != (a_.x[a_.second[e]] < 25.0) ? 0 : -1; });
  EXPECT_TRUE(left.empty());
}

// Found overlapping, as discs are that came together before anything broke near by: no force until they come closer.
TEST_F(LooseDiscs, ThatAreFoundOverlappingCarryNoForceYet) {
  std::int32_t other = -1;
  double least = 1e300;
  for (std::int32_t j = 0; j < a_.disc_count(); ++j) {
    if (j == disc_ || a_.bond_between(disc_, j) >= 0) continue;
    const double gap =
        std::hypot(a_.x[j] - a_.x[disc_], a_.y[j] - a_.y[disc_]) - a_.radius[j] - a_.radius[disc_];
    if (gap < least) other = j;
    least = std::min(least, gap);
  }
  ASSERT_GT(least, 0.0);
  const Vec2 way = a_.position(other) - a_.position(disc_), along = (1.0 / std::sqrt(dot(way, way))) * way;
  const double overlap = 0.05 * a_.mean_radius, closer = 1e-3 * a_.mean_radius;
  const auto push = [&](double by) {
    a_.ux[disc_] += by * along.x;
    a_.uy[disc_] += by * along.y;
  };
  push(std::sqrt(dot(way, way)) - a_.radius[disc_] - a_.radius[other] + overlap);
  Crack crack;
  for (std::int64_t e = 0; e < a_.bond_count(); ++e)
    if (at(e, disc_)) crack.bond = e;
  CrackLog log;
  log.push_back(crack);
  ContactPairs list;
  NonBondedContacts contacts(sim_.options(), list);
  ASSERT_TRUE(contacts.search(a_, *sim_.engine().boundary, log));
  const auto pair = std::find_if(list.pairs.begin(), list.pairs.end(), [&](const ContactPair& p) {
    return std::minmax(p.first, p.second) == std::minmax(disc_, other);
  });
  ASSERT_NE(pair, list.pairs.end());
  double friction = 0.0;
  contacts.cycle(a_, 0.0, friction);
  EXPECT_NEAR(pair->normal_force, 0.0, 1e-9 * sim_.options().contact_normal_stiffness * overlap);
  push(closer);
  contacts.cycle(a_, 0.0, friction);
  EXPECT_NEAR(pair->normal_force, sim_.options().contact_normal_stiffness * closer,
              1e-3 * sim_.options().contact_normal_stiffness * closer);
}

}  // namespace loose_discs_test
