// SPDX-License-Identifier: BSD-3-Clause
// Temperature: its balance, what it does to the rock, and that it goes with the state.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "heat/expansion.hpp"
#include "small_case.hpp"

namespace heat_test {

using namespace testing_unit;

constexpr double rock = 573.15, cold = 293.15;

enum class Way { explicit_substep, quasi_static, coupled };

// Cold water into hot rock that cracks.
CaseDefinition hot_case(Way way) {
  CaseDefinition definition = cracking_case();
  Options& o = definition.options;
  o.packing_disc_count = 600;
  definition.wells[0].radius = 10.0;
  if (way != Way::explicit_substep) o.solver_kind = choice(SolverKind::quasi_static);
  if (way == Way::coupled) {
    o.stepping_mode = choice(SteppingMode::coupled);
    o.stepping_flow_step = 1e-3;
  }
  o.thermal_mode = static_cast<std::int64_t>(ThermalMode::transport);
  o.thermal_rock_temperature = rock;
  o.thermal_fluid_temperature = cold;
  o.thermal_expansion = 1e-5;
  return definition;
}

// The same without a load that cracks it: a little above the formation's pressure, months of cooling.
CaseDefinition cooled_case(double expansion) {
  CaseDefinition definition = hot_case(Way::explicit_substep);
  definition.options.thermal_expansion = expansion;
  definition.options.stepping_flow_step = 5e6;
  definition.wells[0].pressure = 1e6;
  return definition;
}

class HotRock : public testing::TestWithParam<Way> {};

TEST_P(HotRock, TheHeatBalanceCloses) {
  Simulation s(hot_case(GetParam()), {}, {});
  for (int k = 0; k < 4; ++k) s.step();
  EXPECT_GT(s.cracks().size(), 0U);
  const HeatBalance b = heat_balance_of(s.engine());
  EXPECT_LT(b.from_wells, 0.0);
  EXPECT_LT(std::abs(b.error), 1e-9 * std::abs(b.from_wells));
  EXPECT_GE(b.lowest, cold - 1e-9);
  EXPECT_LE(b.highest, rock + 1e-9);
  EXPECT_EQ(s.model().heat->fluid[s.wells()[0].place.domain], cold);
}

TEST_P(HotRock, GoesOnAfterARestoreAsIfNothingHadBeen) {
  Simulation one(hot_case(GetParam()), {}, {}), other(hot_case(GetParam()), {}, {});
  for (int k = 0; k < 2; ++k) one.step();
  std::vector<std::byte> image(one.image_size());
  one.write_image(image);
  other.step();
  other.restore(image);
  EXPECT_EQ(other.state_hash(), one.state_hash());
  for (int k = 0; k < 2; ++k) {
    one.step();
    other.step();
  }
  EXPECT_EQ(other.state_hash(), one.state_hash());
  EXPECT_TRUE(same_bits(other.model().heat->disc, one.model().heat->disc));
}

TEST_P(HotRock, ATriedStepLeavesNoHeatBehind) {
  Simulation s(hot_case(GetParam()), {}, {});
  s.step();
  const auto before = s.state_hash();
  s.begin_step();
  s.try_step(s.options().stepping_flow_step);
  EXPECT_NE(s.state_hash(), before);
  s.reject_step();
  EXPECT_EQ(s.state_hash(), before);
}

INSTANTIATE_TEST_SUITE_P(Ways, HotRock,
                         testing::Values(Way::explicit_substep, Way::quasi_static, Way::coupled));

TEST(Heat, IsTheSameOnAnyNumberOfWorkers) {
  CaseDefinition definition = hot_case(Way::explicit_substep);
  Simulation one(definition, {}, {});
  definition.options.run_workers = 3;
  Simulation three(definition, {}, {});
  for (int k = 0; k < 2; ++k) {
    one.step();
    three.step();
  }
  EXPECT_EQ(one.state_hash(), three.state_hash());
}

TEST(Heat, CoolingCracksTheRockAndWithoutExpansionItDoesNot) {
  Simulation shrinking(cooled_case(3e-5), {}, {}), stiff(cooled_case(0.0), {}, {});
  for (int k = 0; k < 5; ++k) {
    shrinking.step();
    stiff.step();
  }
  EXPECT_EQ(stiff.cracks().size(), 0U);
  ASSERT_GT(shrinking.cracks().size(), 0U);
  EXPECT_LT(heat_balance_of(shrinking.engine()).lowest, 0.5 * (cold + rock));
  // What shrinks pulls, and rock that pulls cracks in tension.
  std::size_t tensile = 0;
  for (const auto& crack : shrinking.cracks()) tensile += crack.mode == CrackMode::tension ? 1 : 0;
  EXPECT_GT(2 * tensile, shrinking.cracks().size());
}

TEST(Heat, EnergyOfGrowthIsInTheBalance) {
  CaseDefinition definition = quiet_case();
  Options& o = definition.options;
  o.boundary_kind = choice(BoundaryKind::walls);
  o.thermal_mode = static_cast<std::int64_t>(ThermalMode::uniform);
  o.thermal_rock_temperature = rock;
  o.thermal_expansion = 1e-5;
  o.stepping_force_ratio = 1e-6;
  o.stepping_max_cycles = 200000;
  Simulation s(definition, {}, {});
  set_temperature(s, rock + 50.0);
  s.step();
  const double work = heat_balance_of(s.engine()).thermal_work;
  EXPECT_GT(work, 0.0);
  EXPECT_LT(std::abs(s.balance().energy_error), 1e-3 * work);
  // A uniform temperature has its heat from the host alone.
  EXPECT_NEAR(heat_balance_of(s.engine()).error, 0.0, 1e-9 * heat_balance_of(s.engine()).from_host);
}

TEST(Heat, AFilmKeepsTheFluidColder) {
  const auto heat_from_well = [](double film) {
    CaseDefinition definition = hot_case(Way::explicit_substep);
    definition.options.thermal_film_coefficient = film;
    definition.options.thermal_expansion = 0.0;
    definition.options.stepping_flow_step = 1e5;
    Simulation s(definition, {}, {});
    s.step();
    return heat_balance_of(s.engine()).from_wells;
  };
  EXPECT_GT(heat_from_well(0.01), heat_from_well(0.0));  // less is taken from the rock
}

TEST(Heat, AProducingWellGetsTheRocksTemperature) {
  CaseDefinition definition = quiet_case();
  Options& o = definition.options;
  o.thermal_mode = static_cast<std::int64_t>(ThermalMode::transport);
  o.thermal_rock_temperature = rock;
  o.thermal_fluid_temperature = cold;
  o.stepping_flow_step = 1e5;
  definition.wells[0].pressure = 20e6;  // below the formation's
  Simulation s(definition, {}, {});
  s.step();
  EXPECT_LT(s.wells()[0].rate, 0.0);
  EXPECT_NEAR(s.model().heat->fluid[s.wells()[0].place.domain], rock, 1e-9);
  EXPECT_NEAR(heat_balance_of(s.engine()).lowest, rock, 1e-9);
}

TEST(Heat, IsNotThereUnlessAskedFor) {
  Simulation s(quiet_case(), {}, {});
  EXPECT_FALSE(s.model().heat);
  EXPECT_TRUE(s.assembly().thermal.empty());
  EXPECT_THROW(set_temperature(s, 300.0), Error);
}

TEST(MicroTable, HasTable3AndIsLinearInBetween) {
  Options o;
  o.thermal_mode = static_cast<std::int64_t>(ThermalMode::uniform);
  o.thermal_parameters = static_cast<std::int64_t>(ThermalParameters::table);
  const MicroTable table(o);
  const double given = o.contact_normal_stiffness;
  EXPECT_NEAR(table.at(523.15).stiffness * given, 11.20e9, 1.0);
  EXPECT_NEAR(table.at(573.15).stiffness * given, 8.98e9, 1.0);
  EXPECT_NEAR(table.at(623.15).stiffness * given, 7.21e9, 1.0);
  EXPECT_NEAR(table.at(673.15).stiffness * given, 5.78e9, 1.0);
  EXPECT_NEAR(table.at(598.15).stiffness * given, 0.5 * (8.98e9 + 7.21e9), 1.0);
  EXPECT_NEAR(table.at(673.15).friction * o.contact_friction, 0.23, 1e-12);
  EXPECT_EQ(table.at(673.15).strength, 1.0);
  EXPECT_NO_THROW(table.require(673.15, "it"));
  try {
    table.require(700.0, "the temperature");
    FAIL() << "700 K is outside the table";
  } catch (const Error& error) {
    const std::string text = error.what();
    for (const char* part : {"700", "523.15", "673.15", "thermal.table_rows"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

TEST(MicroTable, RefusesACaseOutsideItAndRowsOutOfOrder) {
  CaseDefinition definition = hot_case(Way::explicit_substep);
  Options& o = definition.options;
  o.thermal_parameters = static_cast<std::int64_t>(ThermalParameters::table);
  EXPECT_THROW(validate(definition), Error);  // water of 293 K has no micro-parameters in Table 3
  o.thermal_fluid_temperature = 550.0;
  EXPECT_NO_THROW(validate(definition));
  o.thermal_temperature_3 = o.thermal_temperature_2;
  EXPECT_THROW(validate(definition), Error);
}

TEST(MicroTable, GivesWhatTheSameStiffnessGivenDirectlyGives) {
  CaseDefinition by_table = quiet_case(), direct = quiet_case();
  by_table.wells[0].pressure = direct.wells[0].pressure = 40e6;
  for (Options* o : {&by_table.options, &direct.options}) {
    o->contact_mode = choice(ContactMode::after_break);  // contacts that slide remember the way there
    o->stepping_force_ratio = 1e-5;
  }
  by_table.options.thermal_mode = static_cast<std::int64_t>(ThermalMode::uniform);
  by_table.options.thermal_parameters = static_cast<std::int64_t>(ThermalParameters::table);
  by_table.options.thermal_rock_temperature = 673.15;
  Options& o = direct.options;
  for (double* stiffness : {&o.contact_normal_stiffness, &o.contact_shear_stiffness, &o.bond_normal_stiffness,
                            &o.bond_shear_stiffness})
    *stiffness *= by_table.options.thermal_stiffness_4;
  o.contact_friction = 0.23;
  Simulation one(by_table, {}, {}), other(direct, {}, {});
  one.step();
  other.step();
  const auto &a = one.assembly(), &b = other.assembly();
  double most = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < a.ux.size(); ++i) {
    most = std::max(most, std::abs(b.ux[i]));
    apart = std::max(apart, std::abs(a.ux[i] - b.ux[i]));
  }
  EXPECT_GT(most, 0.0);
  EXPECT_LT(apart, 1e-3 * most);
}

TEST(Expansion, KernelsFollowTheLawInEveryInstructionSet) {
  Options o = dry_options(300);
  TestModel model(o, packed(o));
  o.thermal_mode = static_cast<std::int64_t>(ThermalMode::transport);
  o.thermal_parameters = static_cast<std::int64_t>(ThermalParameters::table);
  o.thermal_expansion = 1e-4;
  Array<double> temperature;
  for (std::int64_t i = 0; i < model.assembly.disc_count(); ++i)
    temperature.push_back(523.15 + 150.0 * static_cast<double>(i % 7) / 6.0);
  feel_temperature(model.assembly, temperature, MicroTable(o), o);
  model.shake(1e-2, 3);
  ExplicitSolver solver(model.data, *model.boundary, o, *model.workers);
  const auto bonds = model.assembly.bond_count();
  const auto forces = [&](const char* set) {
    std::vector<BondForce> all(static_cast<std::size_t>(bonds));
    const KernelTable* table = kernels_for(set);
    if (table != nullptr) table->bond_forces(solver.arrays(), all.data());
    return all;
  };
  const auto plain = forces("baseline");
  for (std::int64_t e = 0; e < bonds; ++e) {
    const BondView bond = view_bond(model.assembly, o, e);
    const auto& f = plain[static_cast<std::size_t>(e)];
    const double along = f.fx * bond.normal.x + f.fy * bond.normal.y;
    EXPECT_NEAR(along, bond.normal_force(), 1e-9 * (std::abs(bond.normal_force()) + 1e6));
  }
  for (const char* set : {"avx2", "avx512"}) {
    if (kernels_for(set) == nullptr) continue;
    const auto wide = forces(set);
    EXPECT_EQ(__builtin_memcmp(wide.data(), plain.data(), plain.size() * sizeof(BondForce)), 0) << set;
  }
}

}  // namespace heat_test
