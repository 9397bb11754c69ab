// SPDX-License-Identifier: BSD-3-Clause
// V32  What a growing fracture takes of the energy put in.
//
// Formula    A crack that grows in equilibrium takes G_c = K_Ic^2 / E' per area (Griffith 1921, Irwin 1957), whatever drives it. So works of fluid and
//            far field less what rock, faces and fluid-filled half discs store come to G_c times what the fracture grew by.
// Set-up     Random packings of 100 m, law facet, rate-controlled well with slots, stress 15 and 10 MPa, K_Ic 5 MPa m^0.5, E' 18.6 GPa (T10 of
//            docs/verification/kgd-random.md), quasi-static. The criterion at the tips knows openings alone (frac/tip.hpp), the ledger forces and
//            volumes alone (step/ledger.hpp): nothing makes them agree but equilibrium.
// Measured   The ledger's fracture, damping and friction from the first break to a length of 40 m, over that length and G_c.
// Tolerance  Mean of the packings 20 %, each 40 %.
// Page       docs/verification/V32.md
#include <cstdio>
#include <string>
#include <vector>

#include "small_case.hpp"
#include "support.hpp"

namespace V32_fracture_energy {

using namespace hfrac;
using namespace testing_unit;

constexpr double toughness = 5e6, modulus = 18.6e9;  // Pa m^0.5, Pa
constexpr double farthest = 40.0;                    // m

CaseDefinition growing(std::int64_t seed, std::int64_t discs) {
  CaseDefinition definition;
  Options& o = definition.options;
  o.model_seed = seed;
  o.packing_disc_count = discs;
  make_linear(o);
  o.bond_tensile_strength = 5e6;
  o.bond_shear_strength = 60e6;
  o.bond_fracture_toughness = toughness;
  o.fracture_law = choice(FractureLaw::facet);
  o.fracture_plane_modulus = modulus;
  o.fracture_perforation_length = 1.0;
  o.stress_sigma_Hmax = 15e6;
  o.stress_sigma_hmin = 10e6;
  o.fluid_formation_pressure = 5e6;
  o.fluid_bulk_modulus = 2.2e9;
  o.fluid_viscosity = 0.01;
  o.flow_permeability = 1e-17;
  o.flow_aperture_limit = 0.1;
  o.solver_kind = choice(SolverKind::quasi_static);
  o.stepping_mode = choice(SteppingMode::coupled);
  o.solver_smallest_step = 1e-2;
  o.solver_pressure_change = 0.3;
  o.solver_strength_overshoot = 0.1;
  o.stop_extent_fraction = 1.0;
  WellOptions well;
  well.x = well.y = 50.0;
  well.radius = discs < 2000 ? 3.0 : 2.5;
  well.control = WellControl::rate;
  well.rate = 1e-3;
  definition.wells.push_back(well);
  return definition;
}

double length_of(Simulation& s) {
  double sum = 0.0;
  for (const Fracture& f : s.fractures()) sum += f.length;
  return sum;
}

double taken(const Simulation& s) {
  const Balance b = s.balance();
  return b.fracture + b.damping + b.friction;
}

// What the fracture took over G_c times its new length.
double ratio(std::int64_t seed, std::int64_t discs) {
  Simulation s(growing(seed, discs), {}, {});
  const auto slots = s.cracks().size();
  double length = length_of(s), before = 0.0;
  const double start = length;
  while (length < farthest && s.time() < 1000.0) {
    if (s.cracks().size() == slots) before = taken(s);
    s.step();
    length = length_of(s);
  }
  return (taken(s) - before) / (length - start) / (toughness * toughness / modulus);
}

void compare(std::int64_t discs, const std::vector<std::int64_t>& seeds) {
  double mean = 0.0;
  for (const auto seed : seeds) {
    const double one = ratio(seed, discs);
    mean += one / static_cast<double>(seeds.size());
    verification::report("energy taken over G_c times length, packing " + std::to_string(seed), one, 1.0,
                         0.40);
  }
  verification::report("mean of packings", mean, 1.0, 0.20);
}

TEST(V32FractureEnergySmoke, IsThatOfItsToughness) {
  verification::report("energy taken over G_c times length, 1 500 discs", ratio(1, 1500), 1.0, 0.40);
}

TEST(V32FractureEnergy, IsThatOfItsToughness) {
  compare(4000, {1, 2, 3});
}

TEST(V32FractureEnergyLong, IsThatOfItsToughnessInMorePackings) {
  compare(4000, {4, 5, 6, 7, 8});
}

}  // namespace V32_fracture_energy
