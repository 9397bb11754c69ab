// SPDX-License-Identifier: BSD-3-Clause
// Strengths that follow from a fracture toughness: by the size of discs, and the same in both solvers.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "model.hpp"
#include "solid/toughness.hpp"

namespace toughness_test {

using namespace testing_unit;

TEST(FractureToughness, SetsTheStrengthOfTheMeanDisc) {
  Options o = dry_options(500);
  o.bond_fracture_toughness = 50e6;
  o.bond_toughness_coefficient = 1.25;
  o.bond_tensile_strength = 40e6;
  o.bond_shear_strength = 60e6;
  const TestModel m(o, packed(o));
  const double sigma = 50e6 / (1.25 * std::sqrt(m.assembly.mean_radius));
  EXPECT_NEAR(0.5 * m.assembly.tensile_per_radius, sigma, 1e-9 * sigma);
  EXPECT_NEAR(m.assembly.shear_per_radius / m.assembly.tensile_per_radius, 1.5, 1e-12);
  EXPECT_NEAR(m.assembly.strength_factor, sigma / 40e6, 1e-9 * sigma / 40e6);
}

TEST(FractureToughness, GoesWithTheDiscsAroundABond) {
  // Small discs on the left, discs four times as large on the right.
  Discs discs;
  const auto add = [&](double left, int columns, int rows, double radius) {
    const Discs part = square_lattice(columns, rows, radius);
    for (std::size_t i = 0; i < part.x.size(); ++i) {
      discs.x.push_back(left + part.x[i]);
      discs.y.push_back(part.y[i]);
      discs.radius.push_back(part.radius[i]);
    }
  };
  add(0.0, 16, 16, 0.5);
  add(16.0, 4, 4, 2.0);
  Options o = dry_options(272);
  o.bond_gap_tolerance = 0.2;  // joins the two lattices
  o.bond_fracture_toughness = 50e6;
  const TestModel m(o, discs);
  const auto& a = m.assembly;
  const auto strength_at = [&](double x) {  // of the bond nearest to (x, 8)
    std::int64_t best = 0;
    double nearest = 1e300;
    for (std::int64_t e = 0; e < a.bond_count(); ++e) {
      const double d = std::hypot(0.5 * (a.x[a.first[e]] + a.x[a.second[e]]) - x,
                                  0.5 * (a.y[a.first[e]] + a.y[a.second[e]]) - 8.0);
      if (d < nearest) {
        nearest = d;
        best = e;
      }
    }
    return a.tensile_capacity(best) / (2.0 * a.bond_radius(best));
  };
  EXPECT_NEAR(strength_at(4.0) / strength_at(28.0), 2.0, 0.05);
}

TEST(FractureToughness, TheKernelAndTheViewBreakTheSameBonds) {
  Options o = dry_options(300);
  o.bond_fracture_toughness = 20e6;
  TestModel m(o, packed(o));
  m.shake(2e-3, 3);
  std::int64_t beyond = 0;
  for (std::int64_t e = 0; e < m.assembly.bond_count(); ++e) {
    const BondView bond = view_bond(m.assembly, m.options, e);
    beyond += std::max(bond.tensile_excess, bond.shear_excess) >= 1.0 ? 1 : 0;
  }
  CrackLog log;
  m.solver->run(1, log);
  EXPECT_GT(beyond, 0);
  EXPECT_EQ(static_cast<std::int64_t>(log.size()), beyond);
}

TEST(FractureToughness, IsRefusedBesideAReferenceRadius) {
  CaseDefinition definition;
  definition.options.bond_fracture_toughness = 50e6;
  definition.options.bond_toughness_reference_radius = 1.0;
  EXPECT_THROW(validate(definition), Error);
}

}  // namespace toughness_test
