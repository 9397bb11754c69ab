// SPDX-License-Identifier: BSD-3-Clause
// Fractures from cracks made by hand on a lattice of unit discs around a hole, where every length is known.
#include "frac/fractures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model.hpp"

namespace fractures_test {

using namespace testing_unit;

constexpr double opening = 0.02;  // m

// Twenty by twenty discs of radius 0.5; the hole of radius 2 in the middle takes the twelve discs with
// centres inside.
class LatticeWithHole {
 public:
  LatticeWithHole() : model_(options(), square_lattice(20, 20, 0.5), {{{10.0, 10.0}, 2.0}}) {
    const auto domain = model_.well_domains[0];
    model_.network.kind[domain] = DomainKind::well;
    well_ = {{10.0, 10.0}, std::sqrt(model_.faces.polygon_area[domain] / pi), domain};
  }

  // Breaks the bond whose contact lies at a point.
  void crack(double x, double y, CrackMode mode = CrackMode::tension) {
    for (std::int64_t e = 0; e < model_.assembly.bond_count(); ++e) {
      const Vec2 middle = 0.5 * (model_.assembly.position(model_.assembly.first[e]) +
                                 model_.assembly.position(model_.assembly.second[e]));
      if (std::abs(middle.x - x) > 0.1 || std::abs(middle.y - y) > 0.1) continue;
      model_.assembly.intact[e] = 0.0;
      Crack crack;
      crack.bond = e;
      crack.mode = mode;
      log.push_back(crack);
      return;
    }
    FAIL() << "no bond at " << x << ", " << y;
  }

  // Moves everything above y = 10 up, or everything right of x = 10 to the right.
  void open_across_y() {
    for (std::int64_t i = 0; i < model_.assembly.disc_count(); ++i) {
      if (model_.assembly.y[i] > 10.0) model_.assembly.uy[i] = opening;
    }
  }
  void open_across_x() {
    for (std::int64_t i = 0; i < model_.assembly.disc_count(); ++i) {
      if (model_.assembly.x[i] > 10.0) model_.assembly.ux[i] = opening;
    }
  }

  std::vector<Fracture> find() {
    return find_fractures(model_.assembly, model_.network, model_.options, {well_}, log);
  }

  CrackLog log;
  [[nodiscard]] const WellPlace& well() const { return well_; }
  TestModel& model() { return model_; }

 private:
  static Options options() {
    Options o = dry_options(400);
    o.flow_scheme = choice(FlowScheme::implicit_scheme);
    return o;
  }
  TestModel model_;
  WellPlace well_{};
};

TEST(Fractures, StraightThroughTheWell) {
  LatticeWithHole lattice;
  for (const double x : {12.5, 13.5, 14.5}) lattice.crack(x, 10.0);
  lattice.crack(7.5, 10.0);
  lattice.crack(6.5, 10.0, CrackMode::shear);
  lattice.open_across_y();
  const auto fractures = lattice.find();
  ASSERT_EQ(fractures.size(), 1u);
  const Fracture& f = fractures[0];
  EXPECT_EQ(f.crack_count, 5);
  EXPECT_EQ(f.tensile_cracks, 4);
  EXPECT_EQ(f.well, 0);
  EXPECT_EQ(f.wings, 2);
  // Wings from the contact at the hole to the last pore: 0.5 + 1 + 1 and 0.5 + 1. The hole does not count.
  EXPECT_NEAR(f.length, 2.5 + 1.5, 0.02);
  EXPECT_NEAR(f.extent, 9.0, 1e-9);  // from x = 6 to x = 15, hole and all
  EXPECT_NEAR(f.reach, std::hypot(5.0, 0.5 * opening) - lattice.well().equivalent_radius, 1e-9);
  EXPECT_NEAR(f.azimuth, 0.0, 0.01);
  EXPECT_NEAR(f.largest_aperture, opening, 1e-12);
  EXPECT_NEAR(f.mean_aperture, opening, 1e-12);
  EXPECT_NEAR(f.volume, 5.0 * opening, 1e-12);
  for (const auto& crack : lattice.log) EXPECT_EQ(crack.fracture, 0);
}

TEST(Fractures, AlongYHaveTheAzimuthOfY) {
  LatticeWithHole lattice;
  for (const double y : {12.5, 13.5, 7.5}) lattice.crack(10.0, y);
  lattice.open_across_x();
  const auto fractures = lattice.find();
  ASSERT_EQ(fractures.size(), 1u);
  EXPECT_NEAR(std::abs(fractures[0].azimuth), 0.5 * pi, 0.01);
  EXPECT_NEAR(fractures[0].length, 1.5 + 0.5, 0.02);
  EXPECT_EQ(fractures[0].wings, 2);
}

TEST(Fractures, OnADiagonalLieAtFortyFiveDegrees) {
  LatticeWithHole lattice;
  // A staircase of contacts across which a way leads up and to the right.
  for (int k = 0; k < 5; ++k) {
    lattice.crack(14.5 + k, 14.0 + k);
    lattice.crack(15.0 + k, 14.5 + k);
  }
  const auto fractures = lattice.find();
  ASSERT_EQ(fractures.size(), 1u);
  EXPECT_NEAR(fractures[0].azimuth, 0.25 * pi, 0.02);
  EXPECT_EQ(fractures[0].well, -1);
  EXPECT_EQ(fractures[0].wings, 1);
  EXPECT_EQ(fractures[0].reach, 0.0);
  EXPECT_NEAR(fractures[0].length, 10.0, 1e-9);  // ten cracks, a unit from pore to pore each
}

TEST(Fractures, ThatShareNoPoreAreTwo) {
  LatticeWithHole lattice;
  lattice.crack(3.5, 4.0);
  lattice.crack(12.5, 10.0);
  lattice.crack(13.5, 10.0);
  lattice.crack(4.5, 16.0);
  const auto fractures = lattice.find();
  ASSERT_EQ(fractures.size(), 3u);
  EXPECT_EQ(fractures[0].crack_count, 2);  // most cracks first
  EXPECT_EQ(fractures[0].well, 0);
  EXPECT_EQ(fractures[0].wings, 1);
  EXPECT_EQ(fractures[1].crack_count, 1);
  EXPECT_EQ(fractures[1].well, -1);
  EXPECT_EQ(lattice.log[1].fracture, 0);
  EXPECT_EQ(lattice.log[0].fracture, 1);
  EXPECT_EQ(lattice.log[3].fracture, 2);
  // The outside joins nothing.
  lattice.crack(0.5, 2.0);
  lattice.crack(0.5, 18.0);
  EXPECT_EQ(lattice.find().size(), 5u);
}

TEST(Fractures, BranchesCountTheLongestWay) {
  LatticeWithHole lattice;
  for (const double x : {12.5, 13.5, 14.5, 15.5}) lattice.crack(x, 10.0);
  for (const double y : {10.5, 11.5}) lattice.crack(14.0, y);  // a branch upwards from the pore at x = 14
  const auto fractures = lattice.find();
  ASSERT_EQ(fractures.size(), 1u);
  EXPECT_EQ(fractures[0].crack_count, 6);
  EXPECT_EQ(fractures[0].wings, 1);
  EXPECT_NEAR(fractures[0].length, 3.5, 1e-9);
}

TEST(Fractures, MeanPressureIsThatOfTheirPores) {
  LatticeWithHole lattice;
  lattice.crack(15.5, 10.0);
  Network& n = lattice.model().network;
  n.pressure[n.left[lattice.log[0].bond]] = 30e6;
  n.pressure[n.right[lattice.log[0].bond]] = 40e6;
  EXPECT_NEAR(lattice.find()[0].mean_pressure, 35e6, 1e-6);
}

// What stops a run is the fracture of its wells: a crack elsewhere, however far, is none.
TEST(Fractures, OnlyCracksJoinedToAWellReachOut) {
  LatticeWithHole lattice;
  const auto reach = [&] {
    return farthest_tip(lattice.model().assembly, lattice.model().network, lattice.model().options,
                        {lattice.well()}, lattice.log);
  };
  EXPECT_EQ(reach(), 0.0);
  lattice.crack(17.5, 10.0);
  EXPECT_EQ(reach(), 0.0);
  lattice.crack(12.5, 10.0);
  EXPECT_NEAR(reach(), 3.0, 1e-9);
}

TEST(Fractures, WithoutCracksThereAreNone) {
  LatticeWithHole lattice;
  EXPECT_TRUE(lattice.find().empty());
}

}  // namespace fractures_test
