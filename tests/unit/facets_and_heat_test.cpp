// SPDX-License-Identifier: BSD-3-Clause
// Facets of fractures in rock that cools: free rock shrinks as a whole and its fractures with it; held rock lets go of a fracture's faces, which
// then opens in proportion to the fluid's pressure over the stress that is left (Sneddon 1946: w = 4 (p - sigma) l / E').
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "small_case.hpp"
#include "step/host_state.hpp"
#include "step/simulation.hpp"

namespace facets_and_heat_test {

using namespace testing_unit;

constexpr double rock = 500.0, formation = 5e6, fluid = 12e6;  // K, Pa, Pa

CaseDefinition slotted(std::int64_t seed, BoundaryKind kind) {
  CaseDefinition definition = quiet_case();
  Options& o = definition.options;
  o.model_seed = seed;
  o.packing_disc_count = 1000;
  make_linear(o);
  o.boundary_kind = choice(kind);
  o.stress_sigma_Hmax = o.stress_sigma_hmin = 10e6;
  o.fluid_formation_pressure = formation;
  o.fluid_bulk_modulus =
      1e6;  // pores feel the motion of discs and not their growth (docs/theory.md): not the matter here
  o.flow_permeability = 1e-20;
  o.fracture_law = choice(FractureLaw::facet);
  o.fracture_perforation_length = 6.0;
  o.stepping_mode = choice(SteppingMode::coupled);
  o.solver_kind = choice(SolverKind::quasi_static);
  o.stepping_force_ratio = 1e-7;
  o.stepping_max_cycles = 100000;
  o.stepping_flow_step = 1e5;
  o.thermal_mode = choice(ThermalMode::uniform);
  o.thermal_rock_temperature = rock;
  o.thermal_expansion = 1e-5;
  definition.wells[0].radius = 3.5;
  definition.wells[0].pressure = fluid;
  return definition;
}

std::vector<double> openings(const Simulation& s) {
  std::vector<double> all;
  for (const Facet& f : s.engine().facets.all())
    all.push_back(std::max(0.0, s.engine().facets.opening(s.assembly(), s.network(), f)));
  return all;
}

void rest(Simulation& s) {
  for (int k = 0; k < 6; ++k) s.step();
}

TEST(FacetsAndHeat, FreeRockThatCoolsTakesItsFracturesAlong) {
  for (std::int64_t seed = 1; seed <= 3; ++seed) {
    Simulation s(slotted(seed, BoundaryKind::stress), {}, {});
    rest(s);
    const auto before = openings(s);
    set_temperature(s, rock - 100.0);
    rest(s);
    const auto after = openings(s);
    ASSERT_EQ(before.size(), after.size());
    ASSERT_GT(before.size(), 4U);
    const double widest = *std::max_element(before.begin(), before.end());
    double most = 0.0;
    for (std::size_t k = 0; k < before.size(); ++k) most = std::max(most, std::abs(after[k] - before[k]));
    std::printf(" seed %d: widest %.3f mm, an opening changes by at most %.1e mm\n", static_cast<int>(seed),
                1e3 * widest, 1e3 * most);
    // Lengths change by a thousandth. Without the growth in the law openings would change by a disc's, 3 mm.
    EXPECT_LT(most, 0.005 * widest);
  }
}

TEST(FacetsAndHeat, HeldRockThatCoolsLetsGoOfThem) {
  for (std::int64_t seed = 1; seed <= 3; ++seed) {
    Simulation s(slotted(seed, BoundaryKind::walls), {}, {});
    const auto state = [&] {
      rest(s);
      double volume = 0.0;
      const auto all = openings(s);
      for (std::size_t k = 0; k < all.size(); ++k) volume += all[k] * s.engine().facets.all()[k].length;
      // Slots lie along x and open along y.
      return std::pair{volume, formation + s.engine().boundary->wall_stress(s.assembly()).y};
    };
    const auto [before, pressed] = state();
    set_temperature(s, rock - 10.0);
    const auto [after, left] = state();
    const double expected = (fluid - left) / (fluid - pressed);
    std::printf(" seed %d: stress %.2f to %.2f MPa, volume %.2e to %.2e m2, %.3f of Sneddon's ratio %.3f\n",
                static_cast<int>(seed), 1e-6 * pressed, 1e-6 * left, before, after, after / before / expected,
                expected);
    EXPECT_GT(expected, 1.3);
    EXPECT_NEAR(after / before / expected, 1.0, 0.1);
    set_temperature(s, rock);
    const auto [again, as_before] = state();
    EXPECT_NEAR(again / before, 1.0, 1e-3);
    EXPECT_NEAR(as_before / pressed, 1.0, 1e-3);
  }
}

TEST(FacetsAndHeat, GoOnFromAStateBitForBit) {
  Simulation s(slotted(1, BoundaryKind::stress), {}, {});
  rest(s);
  set_temperature(s, rock - 40.0);
  s.step();
  std::vector<std::byte> image(s.image_size());
  s.write_image(image);
  s.step();
  Simulation twin(slotted(1, BoundaryKind::stress), {}, {});
  twin.restore(image);
  twin.step();
  EXPECT_EQ(twin.state_hash(), s.state_hash());
}

}  // namespace facets_and_heat_test
