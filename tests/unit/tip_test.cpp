// SPDX-License-Identifier: BSD-3-Clause
// K at the tips of a pressurised slit, found from the openings behind them, against linear elastic fracture mechanics: in random
// packings, over a factor of four in disc size, and at any confining stress.
#include "frac/tip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "build/build_model.hpp"
#include "equilibrium/equilibrium_solver.hpp"
#include "lab/crack_tests.hpp"
#include "lab/laboratory.hpp"
#include "options/choices.hpp"

namespace hfrac {
namespace {

constexpr double width = 10.0, net = 1e6;          // m, Pa
constexpr double stiffness = 16e9, shear = 5.6e9;  // N/m
constexpr double plane_modulus = 14.14e9;          // Pa, E' of this rock, drained: hfrac lab elastic

Options rock(double stress) {
  Options o;
  o.model_width = o.model_height = width;
  o.contact_mode = static_cast<std::int64_t>(ContactMode::after_break);
  o.contact_normal_stiffness = o.bond_normal_stiffness = stiffness;
  o.contact_shear_stiffness = o.bond_shear_stiffness = shear;
  o.bond_tensile_strength = o.bond_shear_strength = 1e12;
  o.fluid_formation_pressure = 0.0;
  o.stress_sigma_Hmax = o.stress_sigma_hmin = stress;
  o.stepping_mode = static_cast<std::int64_t>(SteppingMode::coupled);
  o.solver_kind = static_cast<std::int64_t>(SolverKind::quasi_static);
  o.fracture_law = static_cast<std::int64_t>(FractureLaw::facet);
  o.fracture_plane_modulus = plane_modulus;
  return o;
}

// K of both tips over the formula's, in a slit of 0.3 of the width under `stress` + `net`, far pores drained.
std::vector<double> intensities(const Packing& packing, double stress) {
  CaseDefinition definition;
  definition.options = rock(stress);
  const Options& o = definition.options;
  SetupReport report;
  Model m = build_model(definition, packing, {}, report);
  Boundary boundary(m, o);
  Workers workers(1);
  ExplicitSolver mechanics(m, boundary, o, workers);
  mechanics.set_undrained(false);
  Facets facets;
  EquilibriumSolver solver(m, facets, boundary, mechanics, o, workers);
  Assembly& a = m.assembly;
  Network& n = m.network;
  boundary.set_load(a, 1.0);
  EXPECT_EQ(solver.solve(0.0, {}, 1e300, m.cracks).end, EquilibriumSolver::End::rest);
  facets.begin(a, n, {}, o);

  const double begin = 0.35 * width, end = 0.65 * width, middle = 0.5 * width;
  double first = width, last = 0.0, before = 0.0, after = width;
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    const auto i = a.first[e], j = a.second[e];
    if ((a.y[i] - middle) * (a.y[j] - middle) >= 0.0) continue;
    const double x = a.x[i] + (a.x[j] - a.x[i]) * (middle - a.y[i]) / (a.y[j] - a.y[i]);
    if (x < begin) before = std::max(before, x);
    if (x > end) after = std::min(after, x);
    if (x < begin || x > end) continue;
    a.intact[e] = 0;
    first = std::min(first, x);
    last = std::max(last, x);
  }
  facets.update(a, n);
  for (std::int64_t d = 0; d < n.domain_count(); ++d) {
    if (facets.fractured(d)) n.pressure[d] = stress + net;
  }
  EXPECT_EQ(solver.solve(0.0, {}, 1e300, m.cracks).end, EquilibriumSolver::End::rest);
  const double half = 0.25 * (last + after - first - before);
  const double formula = net * std::sqrt(std::numbers::pi * half) *
                         crack_geometry_factor(LabTest::centre_crack, 2.0 * half / width);
  std::vector<double> found;
  for (const Tip& tip : find_tips(facets, a, n, o, 0.0)) found.push_back(tip.intensity / formula);
  return found;
}

struct Spread {
  double mean = 0.0, deviation = 0.0, least = 1e300, most = 0.0;
  std::size_t count = 0;
};
Spread over_packings(int discs, double stress) {
  double sum = 0.0, squares = 0.0;
  Spread s;
  for (int seed = 1; seed <= 4; ++seed) {
    const Packing packing = pack_specimen(rock(0.0), LabTest::pressurised_crack, width, discs, seed);
    for (const double k : intensities(packing, stress)) {
      sum += k;
      squares += k * k;
      s.least = std::min(s.least, k);
      s.most = std::max(s.most, k);
      ++s.count;
    }
  }
  s.mean = sum / static_cast<double>(s.count);
  s.deviation = std::sqrt(std::max(0.0, squares / static_cast<double>(s.count) - s.mean * s.mean));
  std::printf("%5d discs, %2.0f MPa: K over formula %.3f, deviation %.3f, %.3f to %.3f, %zu tips\n", discs,
              1e-6 * stress, s.mean, s.deviation, s.least, s.most, s.count);
  return s;
}

void feels_no_confining_stress(int discs) {
  const Spread unconfined = over_packings(discs, 0.0);
  EXPECT_EQ(unconfined.count, 8U);
  EXPECT_NEAR(unconfined.mean, 1.0, 0.1) << discs;
  EXPECT_LT(unconfined.deviation, 0.15) << discs;
  for (const double stress : {10e6, 30e6}) {
    const Spread confined = over_packings(discs, stress);
    EXPECT_NEAR(confined.mean, 1.0, 0.1) << discs << " discs, " << stress << " Pa";
    EXPECT_NEAR(confined.mean, unconfined.mean, 0.02) << discs << " discs, " << stress << " Pa";
    EXPECT_LT(confined.deviation, 0.15) << discs << " discs, " << stress << " Pa";
  }
}

TEST(Tip, FeelsNoConfiningStressInRandomPackings) {
  for (const int discs : {1000, 4000}) feels_no_confining_stress(discs);
}

// A quarter of the radius of 1 000 discs: with the above a factor of four. Minutes.
TEST(TipSlow, FeelsNoConfiningStressOnFineDiscs) {
  feels_no_confining_stress(16000);
}

}  // namespace
}  // namespace hfrac
