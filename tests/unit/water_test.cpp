// SPDX-License-Identifier: BSD-3-Clause
// Water against the values that the releases give for checking programs, within 0.1 %: IAPWS R7-97 table 5 (region 1, specific volume),
// table 35 (saturation pressure) and R12-08 table 4 (viscosity, without critical enhancement); compressibility. And what a simulation makes of them.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/water.hpp"
#include "small_case.hpp"

namespace water_test {

using namespace testing_unit;

constexpr double a_thousandth = 1e-3;

TEST(Water, HasTheDensityOfTheRelease) {
  const struct {
    double kelvin, pressure, volume;
  } table_5[] = {{300.0, 3e6, 0.100215168e-2}, {300.0, 80e6, 0.971180894e-3}, {500.0, 3e6, 0.120241800e-2}};
  for (const auto& row : table_5) {
    const double ratio = water_density(row.kelvin, row.pressure) * row.volume;
    EXPECT_NEAR(ratio, 1.0, 1e-8);
  }
}

// The release's table 5 has speed of sound w and heat capacity c_p, of which compressibility is v / w^2 + T v alpha^2 / c_p, alpha by differences of
// the density. Measured, at 25 degrees C and atmospheric pressure: 4.5248e-10 1/Pa (Kell 1975); IF97 gives 0.2 % less.
TEST(Water, HasTheCompressibilityOfTheRelease) {
  const struct {
    double kelvin, pressure, sound, heat;
  } table_5[] = {{300.0, 3e6, 1507.73921, 4173.01218},
                 {300.0, 80e6, 1634.69054, 4010.08987},
                 {500.0, 3e6, 1240.71337, 4655.80682}};
  for (const auto& row : table_5) {
    const double rho = water_density(row.kelvin, row.pressure);
    const double alpha =
        (water_density(row.kelvin - 0.01, row.pressure) - water_density(row.kelvin + 0.01, row.pressure)) /
        (0.02 * rho);
    const double compressibility =
        1.0 / (rho * row.sound * row.sound) + row.kelvin * alpha * alpha / (rho * row.heat);
    EXPECT_NEAR(water_bulk_modulus(row.kelvin, row.pressure) * compressibility, 1.0, 1e-7);
  }
  EXPECT_NEAR(1.0 / water_bulk_modulus(298.15, 101325.0), 4.5248e-10, 3e-3 * 4.5248e-10);
}

TEST(Water, BoilsWhereTheReleaseSays) {
  EXPECT_NEAR(saturation_pressure(300.0), 0.353658941e4, a_thousandth * 3.5e3);
  EXPECT_NEAR(saturation_pressure(500.0), 0.263889776e7, a_thousandth * 2.6e6);
  EXPECT_NEAR(saturation_pressure(600.0), 0.123443146e8, a_thousandth * 1.2e7);
}

TEST(Water, HasTheViscosityOfTheRelease) {
  const struct {
    double kelvin, density, viscosity;
  } table_4[] = {{298.15, 998.0, 889.735100}, {298.15, 1200.0, 1437.649467}, {373.15, 1000.0, 307.883622},
                 {433.15, 1.0, 14.538324},    {433.15, 1000.0, 217.685358},  {873.15, 1.0, 32.619287},
                 {873.15, 100.0, 35.802262},  {873.15, 600.0, 77.430195},    {1173.15, 1.0, 44.217245},
                 {1173.15, 100.0, 47.640433}, {1173.15, 400.0, 64.154608}};
  for (const auto& row : table_4)
    EXPECT_NEAR(water_viscosity(row.kelvin, row.density) * 1e6 / row.viscosity, 1.0,
                1e-7);  // eight digits are printed
}

TEST(Water, OfTheFormationIsTheFluidOfARunWithoutTemperature) {
  CaseDefinition definition = quiet_case();
  definition.options.fluid_kind = choice(FluidKind::water);
  definition.options.thermal_rock_temperature = 423.15;
  Simulation s(definition, {}, {});
  EXPECT_EQ(s.options().fluid_viscosity, water_viscosity(423.15, water_density(423.15, 25e6)));
  EXPECT_EQ(s.options().thermal_fluid_density, water_density(423.15, 25e6));
  EXPECT_EQ(s.options().fluid_bulk_modulus, water_bulk_modulus(423.15, 25e6));
  EXPECT_TRUE(s.network().viscosity_share.empty());
}

// Cold water in hot rock: pipes of the cold pores let through less, as the pores' own kinematic viscosities say, and no fluid is lost.
TEST(Water, FollowsTheTemperatureOfEveryPore) {
  for (const auto mode : {SteppingMode::substep, SteppingMode::coupled}) {
    CaseDefinition definition = quiet_case();
    Options& o = definition.options;
    o.fluid_kind = choice(FluidKind::water);
    o.thermal_mode = choice(ThermalMode::transport);
    o.thermal_parameters = choice(ThermalParameters::constant);
    o.thermal_expansion = 0.0;
    o.thermal_rock_temperature = 473.15;
    o.thermal_fluid_temperature = 293.15;
    o.flow_permeability = 1e-12;
    o.stepping_flow_step = 100.0;
    o.stepping_mode = choice(mode);
    if (mode == SteppingMode::coupled) o.solver_kind = choice(SolverKind::quasi_static);
    Simulation s(definition, {}, {});
    for (int k = 0; k < 3; ++k) s.step();
    const Network& n = s.network();
    const HeatState& heat = *s.model().heat;
    double largest = 0.0, smallest = 1e9;
    for (std::size_t p = 0; p < n.left.size(); ++p) {
      const auto l = static_cast<std::size_t>(n.left[p]), r = static_cast<std::size_t>(n.right[p]);
      const double mean = 0.5 * (water_kinematic_viscosity_at(heat.fluid[l], n.pressure[l]) +
                                 water_kinematic_viscosity_at(heat.fluid[r], n.pressure[r]));
      EXPECT_NEAR(n.viscosity_share[p] * s.options().fluid_viscosity / s.options().thermal_fluid_density,
                  mean, 1e-9 * mean);
      largest = std::max(largest, n.viscosity_share[p]);
      smallest = std::min(smallest, n.viscosity_share[p]);
    }
    EXPECT_GT(largest, 2.0);
    EXPECT_NEAR(smallest, 1.0, 0.05);
    EXPECT_LE(std::abs(s.balance().fluid_error), 1e-12 * s.balance().injected);
    std::vector<std::byte> image(s.image_size());
    s.write_image(image);
    s.step();
    const auto after = s.state_hash();
    s.restore(image);
    s.step();
    EXPECT_EQ(s.state_hash(), after);
  }
}

// In rock that lets nothing through and does not give, pores keep their water: dp = K (rho_0 / rho - 1 - 2 alpha dT), the void growing as
// the discs do (Palciauskas and Domenico 1982, with grains and rock of one thermal expansion).
TEST(Water, HeatedInTightRockRaisesItsPressure) {
  for (const auto solver : {SolverKind::explicit_solver, SolverKind::quasi_static}) {
    for (const double alpha : {0.0, 1e-4}) {
      CaseDefinition definition = quiet_case();
      definition.wells.clear();
      Options& o = definition.options;
      make_linear(o);
      o.packing_disc_count = 200;
      o.contact_normal_stiffness = o.bond_normal_stiffness = 16e13;
      o.contact_shear_stiffness = o.bond_shear_stiffness = 5.6e13;
      o.solver_kind = choice(solver);
      if (solver == SolverKind::quasi_static) o.stepping_mode = choice(SteppingMode::coupled);
      o.fluid_kind = choice(FluidKind::water);
      o.thermal_mode = choice(ThermalMode::uniform);
      o.thermal_parameters = choice(ThermalParameters::constant);
      o.thermal_expansion = alpha;
      o.thermal_rock_temperature = 373.15;
      o.flow_permeability = 1e-26;
      o.stepping_flow_step = 1e-3;
      o.stepping_force_ratio = 1e-6;
      o.stepping_max_cycles = 200000;
      Simulation s(definition, {}, {});
      for (const double warmer : {10.0, 20.0}) {
        set_temperature(s, 373.15 + warmer);
        s.step();
        const double p_0 = o.fluid_formation_pressure, t = 373.15 + warmer;
        const double expected =
            water_bulk_modulus(t, p_0) *
            (water_density(373.15, p_0) / water_density(t, p_0) - 1.0 - 2.0 * alpha * warmer);
        const Network& n = s.network();
        double sum = 0.0, count = 0.0;
        for (std::size_t d = 1; d < n.kind.size(); ++d) {
          if (n.kind[d] != DomainKind::rock) continue;
          sum += n.pressure[d] - n.reference_pressure;
          ++count;
        }
        EXPECT_NEAR(sum / count / expected, 1.0, 0.02) << alpha << ", " << warmer << " K";
      }
    }
  }
}

TEST(Water, IsRefusedWhereItsLawsDoNotHold) {
  CaseDefinition definition = quiet_case();
  definition.options.fluid_kind = choice(FluidKind::water);
  definition.options.thermal_rock_temperature = 700.0;
  EXPECT_THROW(validate(definition), Error);
  definition.options.thermal_rock_temperature = 500.0;
  definition.options.fluid_formation_pressure = 1e6;  // steam
  EXPECT_THROW(validate(definition), Error);
  definition.options.fluid_formation_pressure = 25e6;
  validate(definition);
}

}  // namespace water_test
