// SPDX-License-Identifier: BSD-3-Clause
// Wellbores: perforation and near-well friction, storage and how a rate divides among clusters, against solutions by hand within 1 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "flow/wellbore_flow.hpp"
#include "small_case.hpp"
#include "step/simulation.hpp"

namespace wellbore_test {

using namespace testing_unit;

constexpr double one_percent = 0.01;

double hole_pressure(const Simulation& s, std::size_t well) {
  return s.network().pressure[s.wells()[well].place.domain];
}

TEST(WellFriction, IsThatOfOrificesAndOfTheWayBehindThem) {
  const WellFriction perforations = well_friction(1000.0, 10.0, 0.01, 0.7, 0.0, 20.0);
  const double rate = 0.02 / 20.0, flow = 0.02;  // m2/s, m3/s
  const double by_hand = 8.0 * 1000.0 * flow * flow /
                         (std::numbers::pi * std::numbers::pi * 10.0 * 10.0 * std::pow(0.01, 4) * 0.7 * 0.7);
  EXPECT_NEAR(perforations.drop(rate), by_hand, 1e-4 * by_hand);
  EXPECT_EQ(perforations.drop(-rate), -perforations.drop(rate));
  const WellFriction way = well_friction(1000.0, 0.0, 0.0, 0.0, 5e6, 20.0);
  EXPECT_NEAR(way.drop(rate), 5e6 * std::sqrt(flow), 1e-9 * 5e6);
  EXPECT_FALSE(well_friction(1000.0, 0.0, 0.0, 0.0, 0.0, 0.0).any());
  // A coefficient of 0 is 0.6, a length of 0 is 1 m.
  EXPECT_EQ(well_friction(1000.0, 10.0, 0.01, 0.0, 0.0, 0.0).square,
            well_friction(1000.0, 10.0, 0.01, 0.6, 0.0, 1.0).square);
}

TEST(WellFriction, TheRateOfADropHasThatDropAndItsSlope) {
  for (const WellFriction& law : {WellFriction{1e12, 0.0}, WellFriction{0.0, 1e8}, WellFriction{3e11, 2e7}}) {
    for (const double rate : {1e-9, 1e-6, 1e-3, 0.1}) {
      const double drop = law.drop(rate);
      const auto answer = law.respond(drop), back = law.respond(-drop);
      EXPECT_NEAR(answer.rate, rate, 1e-10 * rate);
      EXPECT_EQ(back.rate, -answer.rate);
      const double step = 1e-6 * drop;
      EXPECT_NEAR(answer.slope,
                  (law.respond(drop + step).rate - law.respond(drop - step).rate) / (2.0 * step),
                  1e-5 * answer.slope);
    }
  }
}

Wellbore two_clusters(double first, double second) {
  Wellbore wellbore;
  wellbore.clusters = {{0, 1, {first, 0.0}, 0.0}, {1, 2, {second, 0.0}, 0.0}};
  return wellbore;
}

TEST(WellboreFlow, DividesARateByTheRootsOfTheResistances) {
  Wellbore wellbore = two_clusters(1e12, 4e12);
  wellbore.rate = 3e-3;
  WellboreFlow flow;
  flow.begin(wellbore, 1.0, 0.0);
  const std::vector<double> hole{30e6, 30e6};
  flow.solve(hole);
  EXPECT_NEAR(flow.rate(0), 2e-3, 1e-3 * 2e-3);
  EXPECT_NEAR(flow.rate(1), 1e-3, 1e-3 * 1e-3);
  EXPECT_NEAR(flow.pressure(), 30e6 + 4e6, 1e-3 * 4e6);
  EXPECT_EQ(flow.rate(0) + flow.rate(1), 3e-3);
  // Its answer to the holes' pressures, against differences.
  for (std::size_t j = 0; j < 2; ++j) {
    std::vector<double> other = hole;
    other[j] += 100.0;
    WellboreFlow moved;
    moved.begin(wellbore, 1.0, 0.0);
    moved.solve(other);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR((moved.rate(i) - flow.rate(i)) / 100.0, flow.by_pressure(i, j),
                  1e-3 * flow.by_pressure(0, 1));
  }
}

TEST(WellboreFlow, ShutInLetsOneClusterFeedTheOther) {
  Wellbore wellbore = two_clusters(1e12, 1e12);
  WellboreFlow flow;
  flow.begin(wellbore, 1.0, 0.0);
  flow.solve(std::vector<double>{32e6, 30e6});
  EXPECT_NEAR(flow.rate(0), -1e-3, 1e-5);  // 1 MPa on each side
  EXPECT_NEAR(flow.rate(1), 1e-3, 1e-5);
  EXPECT_NEAR(flow.pressure(), 31e6, 1e3);
}

TEST(WellboreFlow, APumpThatTakesOutMoreThanTheFrictionLetsGetsLess) {
  Wellbore wellbore = two_clusters(1e12, 1e12);
  wellbore.rate = -1.0;
  wellbore.storage = 1e-10;
  wellbore.pressure = wellbore.start_pressure = 30e6;
  WellboreFlow flow;
  flow.begin(wellbore, 1.0, 0.0);
  flow.solve(std::vector<double>{25e6, 25e6});
  EXPECT_EQ(flow.pressure(), 0.0);
  EXPECT_NEAR(flow.rate(0), -5e-3, 1e-5);
  flow.keep(wellbore);
  EXPECT_NEAR(wellbore.pumped, -1e-2 - 1e-10 * 30e6, 2e-5);
}

// In rock that lets nothing in, dp / dt = Q / C, C the wellbore's storage and what the hole stores by itself, which a run without tells.
TEST(WellboreStorage, RisesByTheRateOverIt) {
  for (const auto mode : {SteppingMode::substep, SteppingMode::coupled}) {
    CaseDefinition definition = quiet_case();
    Options& o = definition.options;
    o.flow_permeability = 1e-22;
    o.stepping_force_ratio = 1e-6;  // what damped motion leaves would be seen in the pressure
    o.stepping_mode = choice(mode);
    if (mode == SteppingMode::coupled) o.solver_kind = choice(SolverKind::quasi_static);
    WellOptions& well = definition.wells[0];
    well.control = WellControl::rate;
    well.rate = 10.0;
    Simulation alone(definition, {}, {});
    alone.step();
    const double own = 10.0 / (hole_pressure(alone, 0) - 25e6);  // m2/Pa
    for (const double near_well : {0.0, 1e4}) {  // part of the hole, or beyond a little friction
      well.storage = 2e-5;
      well.near_well_friction = near_well;
      Simulation s(definition, {}, {});
      for (int k = 1; k <= 5; ++k) {
        s.step();
        const double rise = k * 10.0 / (2e-5 + own);
        // Beyond friction that of the wellbore: in mode substep a hole gives way after the flow and is filled in the next step.
        const double pressure = near_well > 0.0 ? s.model().wellbores.front().pressure : hole_pressure(s, 0);
        EXPECT_NEAR(pressure - 25e6, rise, one_percent * rise);
      }
      EXPECT_LE(std::abs(s.balance().fluid_error), 1e-12 * s.balance().injected);
      EXPECT_NEAR(s.balance().injected, 50.0, 1e-10);
    }
    EXPECT_LT(own, 0.1 * 2e-5);  // or the storage would not be what is tested
  }
}

// In rock that lets nothing in, a fluid far softer than the rock: dp / dt = Q K_f / A, whatever the packing left as a hole.
TEST(FluidArea, IsWhatAHoleHoldsInEveryWayOfStepping) {
  constexpr double area = 100.0, bulk = 1e7, rate = 0.5;  // m2, Pa, m2/s
  for (const auto mode : {SteppingMode::substep, SteppingMode::dynamic, SteppingMode::coupled}) {
    CaseDefinition definition = quiet_case();
    Options& o = definition.options;
    o.flow_permeability = 1e-22;
    o.fluid_bulk_modulus = bulk;
    o.stepping_force_ratio = 1e-6;
    o.stepping_mode = choice(mode);
    if (mode == SteppingMode::dynamic) o.stepping_flow_step = 0.02;
    if (mode == SteppingMode::coupled) o.solver_kind = choice(SolverKind::quasi_static);
    definition.wells[0].control = WellControl::rate;
    definition.wells[0].rate = rate;
    definition.wells[0].fluid_area = area;
    Simulation s(definition, {}, {});
    const auto held = [&s] { return s.network().fluid_in(s.wells()[0].place.domain); };
    const double before = held();  // the far field has pressed the hole together
    EXPECT_NEAR(before, area, one_percent * area);
    for (int k = 0; k < 3; ++k) s.step();
    const double pumped = 3.0 * rate * o.stepping_flow_step, rise = pumped * bulk / area;
    EXPECT_NEAR(hole_pressure(s, 0) - 25e6, rise, one_percent * rise);
    EXPECT_LE(std::abs(s.balance().fluid_error), 1e-12 * pumped);
    EXPECT_NEAR(held() - before, pumped, 1e-6 * pumped);
  }
}

TEST(FluidArea, TheVoidItselfChangesNoBitAndAnotherAreaIsAnotherModel) {
  CaseDefinition definition = quiet_case();
  Simulation as_it_is(definition, {}, {});
  const double hole = as_it_is.network().volume[as_it_is.wells()[0].place.domain];
  EXPECT_GT(hole, 1.05 * std::numbers::pi * 10.0 * 10.0);  // larger than asked
  definition.wells[0].fluid_area = hole;
  Simulation given(definition, {}, {});
  as_it_is.step();
  given.step();
  EXPECT_EQ(given.state_hash(), as_it_is.state_hash());
  std::vector<std::byte> image(given.image_size());
  given.write_image(image);
  as_it_is.restore(image);
  EXPECT_EQ(as_it_is.state_hash(), given.state_hash());
  definition.wells[0].fluid_area = 0.5 * hole;
  Simulation other(definition, {}, {});
  EXPECT_THROW(other.restore(image), Error);
}

TEST(FluidArea, NeedsFlowAndIsNoneBelowZero) {
  for (const double area : {10.0, -1.0}) {
    CaseDefinition definition = quiet_case();
    if (area > 0.0) definition.options.flow_scheme = choice(FlowScheme::off);
    definition.wells[0].fluid_area = area;
    const std::string wanted = area > 0.0 ? "well[0].fluid_area = 10 m2 needs flow"
                                          : "well[0].fluid_area = -1 is outside 0 to 1e12 m2";
    try {
      const Simulation s(definition, {}, {});
      FAIL() << wanted;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << error.what();
    }
  }
}

// Shut in, the wellbore empties into rock that flows steadily: pressure falls as exp(-G t / C), G = rate over pressure at rest.
TEST(WellboreStorage, EmptiesExponentially) {
  CaseDefinition definition = quiet_case();
  Options& o = definition.options;
  o.fluid_bulk_modulus = 1e11;  // of pores that store little
  o.flow_permeability = 1e-11;
  o.stepping_mode = choice(SteppingMode::coupled);  // what damped motion leaves would be seen in the rate
  o.solver_kind = choice(SolverKind::quasi_static);
  o.stepping_flow_step = 2000.0;  // 20 of them to come to a steady flow
  definition.wells[0].pressure = 25.1e6;
  definition.wells[0].storage = 1e-3;  // far above what the rock stores as it gives
  Simulation s(definition, {}, {});
  for (int k = 0; k < 20; ++k) s.step();
  const double conductance = s.wells()[0].rate / 0.1e6, time = 1e-3 / conductance;
  set_well_rate(s, 0, 0.0);
  const double step = time / 400.0;
  for (int k = 0; k < 400; ++k) s.step(s.loads(), step);
  EXPECT_NEAR((hole_pressure(s, 0) - 25e6) / 0.1e6, std::exp(-1.0), one_percent * std::exp(-1.0));
  EXPECT_LE(std::abs(s.balance().fluid_error), 1e-12 * s.balance().injected);
}

CaseDefinition two_holes(SteppingMode mode) {
  CaseDefinition definition = quiet_case();
  Options& o = definition.options;
  o.packing_disc_count = 900;
  o.stepping_mode = choice(mode);
  if (mode == SteppingMode::coupled) o.solver_kind = choice(SolverKind::quasi_static);
  WellOptions& first = definition.wells[0];
  first = {30.0, 50.0, 8.0};
  first.control = WellControl::rate;
  first.rate = 3e-3;
  first.height = 10.0;
  first.perforation_count = 4.0;
  first.perforation_diameter = 0.01;
  first.discharge_coefficient = 0.8;
  first.wellbore = 1;
  WellOptions second = first;
  second.x = 70.0;
  second.rate = 0.0;
  second.control = WellControl::pressure;
  second.pressure = 0.0;
  second.perforation_count = 2.0;
  definition.wells.push_back(second);
  return definition;
}

TEST(SharedWellbore, DividesItsRateInEveryModeOfStepping) {
  for (const auto mode : {SteppingMode::substep, SteppingMode::dynamic, SteppingMode::coupled}) {
    CaseDefinition definition = two_holes(mode);
    if (mode == SteppingMode::dynamic) definition.options.stepping_flow_step = 1e-3;
    Simulation s(definition, {}, {});
    for (int k = 0; k < 4; ++k) s.step();
    const Wellbore& wellbore = s.model().wellbores.front();
    const double q0 = wellbore.clusters[0].rate, q1 = wellbore.clusters[1].rate;
    EXPECT_NEAR(q0 + q1, 3e-3, 1e-15);
    EXPECT_NEAR(q0 / q1, 2.0, one_percent * 2.0);  // drops of MPa, holes that differ by little
    const double drop =
        8.0 * 1000.0 * std::pow(10.0 * q0, 2) / (std::numbers::pi * std::numbers::pi * 16.0 * 1e-8 * 0.64);
    if (mode == SteppingMode::coupled) {
      EXPECT_NEAR(wellbore.pressure - hole_pressure(s, 0), drop, one_percent * drop);
    }
    EXPECT_NEAR(s.wells()[0].injected + s.wells()[1].injected, s.balance().injected, 1e-14);
    // Of what was injected, or of the holes' volume changes, whose digits the books have.
    EXPECT_LE(std::abs(s.balance().fluid_error), 1e-12 * std::max(s.balance().injected, 1e-3));
    EXPECT_EQ(wellbore.pump_rate, 3e-3);
  }
}

TEST(SharedWellbore, FlowsBackShutsInAndIsHeldAndItsBooksStayBalanced) {
  for (const auto mode : {SteppingMode::substep, SteppingMode::coupled}) {
    CaseDefinition definition = two_holes(mode);
    definition.wells[0].storage = definition.wells[1].storage = 1e-9;
    definition.wells[1].near_well_friction = 1e6;
    Simulation s(definition, {}, {});
    double moved = 0.0;
    for (const double rate : {3e-3, 3e-3, 0.0, -1e-3, 2e-3, -2e-3, 0.0, 0.0}) {
      set_well_rate(s, 0, rate);
      s.step();
      moved += std::abs(rate);
      EXPECT_NEAR(s.model().wellbores.front().pump_rate, rate, 1e-14);
    }
    set_well_pressure(s, 0, 27e6);
    s.step();
    EXPECT_EQ(s.model().wellbores.front().pressure, 27e6);
    EXPECT_GT(s.wells()[1].rate, 0.0);
    EXPECT_LE(std::abs(s.balance().fluid_error), 1e-12 * moved);
  }
}

TEST(SharedWellbore, ImageAndHashHoldIt) {
  CaseDefinition definition = two_holes(SteppingMode::coupled);
  definition.wells[0].storage = 1e-8;
  Simulation s(definition, {}, {});
  s.step();
  std::vector<std::byte> image(s.image_size());
  s.write_image(image);
  const auto before = s.state_hash();
  s.step();
  const auto after = s.state_hash();
  s.restore(image);
  EXPECT_EQ(s.state_hash(), before);
  s.step();
  EXPECT_EQ(s.state_hash(), after);
}

TEST(SharedWellbore, IsRefusedInWordsWhereItCannotBe) {
  const auto fault = [](const CaseDefinition& definition) {
    try {
      validate(definition);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CaseDefinition definition = two_holes(SteppingMode::substep);
  EXPECT_EQ(fault(definition), "");
  definition.wells[1].rate = 1e-3;
  EXPECT_NE(fault(definition).find("which well[0] drives"), std::string::npos);
  definition = two_holes(SteppingMode::substep);
  definition.wells[1].perforation_count = 0.0;
  EXPECT_NE(fault(definition).find("has no friction"), std::string::npos);
  definition = two_holes(SteppingMode::substep);
  definition.wells[0].perforation_diameter = 0.0;
  EXPECT_NE(fault(definition).find("lets nothing through"), std::string::npos);
  definition = two_holes(SteppingMode::substep);
  definition.options.flow_scheme = choice(FlowScheme::explicit_scheme);
  EXPECT_NE(fault(definition).find("explicit"), std::string::npos);
  Simulation s(two_holes(SteppingMode::substep), {}, {});
  EXPECT_THROW(set_well_rate(s, 1, 1e-3), Error);
}

}  // namespace wellbore_test
