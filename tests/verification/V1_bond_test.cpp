// SPDX-License-Identifier: BSD-3-Clause
// V1  A bond between two discs, loaded to failure in tension, shear and bending.
//
// Formula    tension F = sigma_c A, shear F = tau_c A, bending M = sigma_c I / R (beta = 1), and together
//            F / A + M R / I = sigma_c, with A = 2 R, I = 2/3 R^3 per metre of thickness and R the
//            smaller radius.
// Source     Potyondy and Cundall 2004, eq. 16-23 of the paper as read in physics.md 1.2 and 1.3.
// Set-up     Discs of radius 0.5 m and 0.8 m, bonded, 42.5 and 30 MPa. One disc is displaced or turned,
//            one mechanical cycle is run, the crack log says whether the bond broke; bisection finds the
//            load at which it does. Small displacements: a bond at failure is stretched by 8e-3 of its
//            length, so bonds are made 1e4 times stiffer.
// Tolerance  1e-5 of the strength.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "model.hpp"
#include "support.hpp"

namespace V1_bond {

using namespace testing_unit;

constexpr double tolerance = 1e-5;
constexpr double small_radius = 0.5, large_radius = 0.8;
constexpr double area = 2.0 * small_radius,
                 second_moment = 2.0 / 3.0 * small_radius * small_radius * small_radius;

class TwoDiscs {
 public:
  TwoDiscs() {
    options_.flow_scheme = choice(FlowScheme::off);
    options_.contact_mode = choice(ContactMode::after_break);
    options_.bond_normal_stiffness = 5e13;
    options_.bond_shear_stiffness = 4e13;
    options_.bond_tensile_strength = 42.5e6;
    options_.bond_shear_strength = 30e6;
    graph_.x = {0.0, 1.3};
    graph_.y = {0.0, 0.0};
    graph_.radius = {small_radius, large_radius};
    graph_.first = {0};
    graph_.second = {1};
    graph_.bonded = {1};
    graph_.part_first_edge = {0, 1};
    graph_.tile_first_pair = {1, 1};
    graph_.mean_radius = 0.65;
  }

  // What the second disc does, times a factor: displacement along the bond, across it, and the turns of both
  // discs.
  struct Motion {
    double along = 0.0, across = 0.0, turn_first = 0.0, turn_second = 0.0;
  };

  // The bond as it fails: the smallest factor at which one cycle breaks it.
  struct Failure {
    BondView bond;
    CrackMode mode;
  };
  [[nodiscard]] Failure fail(const Motion& motion) const {
    double below = 0.0, above = 1.0;
    Failure failure{};
    for (int round = 0; round < 60; ++round) {
      const double factor = 0.5 * (below + above);
      const auto [broken, at] = breaks(motion, factor);
      if (broken) {
        above = factor;
        failure = at;
      } else {
        below = factor;
      }
    }
    return failure;
  }

 private:
  [[nodiscard]] std::pair<bool, Failure> breaks(const Motion& motion, double factor) const {
    hfrac::Model model;
    Assembly& a = model.assembly;
    a = build_assembly(graph_, options_);
    const Faces faces = build_faces(graph_);
    model.network = build_network(faces, a, {}, options_);
    Boundary boundary(model, options_);
    Workers workers(1);
    ExplicitSolver solver(model, boundary, options_, workers);
    a.ux[1] = factor * motion.along;
    a.uy[1] = factor * motion.across;
    a.rotation[0] = factor * motion.turn_first;
    a.rotation[1] = factor * motion.turn_second;
    Failure failure{view_bond(a, options_, 0), CrackMode::tension};
    CrackLog log;
    solver.run(1, log);
    if (log.empty()) return {false, failure};
    failure.mode = log[0].mode;
    return {true, failure};
  }

  Options options_;
  ContactGraph graph_;
};

TEST(V1BondSmoke, Tension) {
  const auto failure = TwoDiscs().fail({1e-5, 0.0, 0.0, 0.0});
  verification::report("tension: F at failure, N", failure.bond.bond_normal, 42.5e6 * area, tolerance);
  EXPECT_EQ(failure.mode, CrackMode::tension);
}

TEST(V1BondSmoke, Shear) {
  // Both discs turned alike: the contact slides, the bond does not bend.
  const auto failure = TwoDiscs().fail({0.0, 0.0, -1e-5, -1e-5});
  verification::report("shear by turning: F at failure, N", failure.bond.bond_shear, 30e6 * area, tolerance);
  EXPECT_EQ(failure.mode, CrackMode::shear);
  EXPECT_NEAR(failure.bond.bond_moment, 0.0, 1e-3);
  const auto across = TwoDiscs().fail({0.0, 1e-5, 0.0, 0.0});
  verification::report("shear by displacement: F at failure, N", across.bond.bond_shear, 30e6 * area,
                       tolerance);
  EXPECT_EQ(across.mode, CrackMode::shear);
}

TEST(V1BondSmoke, Bending) {
  // Turned against each other as gears are: the contact does not slide.
  const auto failure = TwoDiscs().fail({0.0, 0.0, -1e-4 * large_radius, 1e-4 * small_radius});
  verification::report("bending: M at failure, N m", failure.bond.bond_moment,
                       42.5e6 * second_moment / small_radius, tolerance);
  EXPECT_EQ(failure.mode, CrackMode::tension);
  EXPECT_NEAR(failure.bond.bond_shear, 0.0, 1.0);
}

TEST(V1BondSmoke, TensionAndBendingTogether) {
  const auto failure = TwoDiscs().fail({4e-7, 0.0, -1e-6 * large_radius, 1e-6 * small_radius});
  const double stress =
      failure.bond.bond_normal / area + failure.bond.bond_moment * small_radius / second_moment;
  verification::report("tension and bending: F/A + M R/I, Pa", stress, 42.5e6, tolerance);
  EXPECT_GT(failure.bond.bond_normal / area, 0.1 * 42.5e6);
  EXPECT_LT(failure.bond.bond_normal / area, 0.9 * 42.5e6);
  verification::Curves curves("V1", "What a bond of 0.5 m bears in tension and bending together",
                              "normal force (MN),bending moment (MN m)");
  for (int k = 0; k <= 10; ++k) {
    const double pulled = 2e-7 * k, turned = 3e-7 * (10 - k);
    const auto at = TwoDiscs().fail({pulled, 0.0, -turned * large_radius, turned * small_radius});
    curves.point("model", {1e-6 * at.bond.bond_normal, 1e-6 * at.bond.bond_moment});
  }
  curves.line("F/A + M R/I = sigma_c", 0.0, 42.5 * area, [](double force) {
    return std::vector<double>{(42.5 - force / area) * second_moment / small_radius};
  });
}

TEST(V1BondSmoke, CompressionDoesNotBreak) {
  // eq. 21's |F_n| would break a bond in compression (physics.md 1.3).
  const auto failure = TwoDiscs().fail({-1e-3, 0.0, 0.0, 0.0});
  verification::report_absolute("compression: F at failure, N; 0: none was found", failure.bond.bond_normal,
                                0.0, 0.0);
}

}  // namespace V1_bond
