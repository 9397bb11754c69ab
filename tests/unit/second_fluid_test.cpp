// SPDX-License-Identifier: BSD-3-Clause
// A second fluid that displaces the first: along a line of pipes against the solution of piston-like displacement, in whole simulations by its
// books, by the pressure once all is displaced, by what the wellbore feels, and where it is refused.
#include "flow/second_fluid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/error.hpp"
#include "flow/flow_solver.hpp"
#include "fluid_in_rock.hpp"
#include "host/host_grid.hpp"
#include "small_case.hpp"

namespace second_fluid_test {

using namespace testing_unit;

// A slot of width w and length L between parallel plates as a row of pores; fluid goes in at its beginning and out at a pressure of 0.
struct Slot {
  static constexpr int cells = 100;
  static constexpr double width = 1e-3, length = 50.0, viscosity = 1e-3, rate = 1e-4;  // m, m, Pa s, m2/s
  static constexpr std::int32_t well = cells + 1;
  Network n;
  double ratio;  // of the viscosities

  explicit Slot(double viscosities) : ratio(viscosities) {
    const double cell = length / cells;
    n.kind.assign(cells + 2, DomainKind::rock);
    n.kind[0] = DomainKind::outside;
    n.kind[well] = DomainKind::well;
    n.volume.assign(cells + 2, width * cell);
    n.storing = n.volume;
    for (auto* values : {&n.volume_change, &n.content, &n.pressure, &n.second_content})
      values->assign(cells + 2, 0.0);
    n.floor_pressure = -1e12;
    n.stiffness.assign(cells + 2, 1e12 / (width * cell));
    n.stiffness[0] = 0.0;
    for (std::int32_t p = 0; p <= cells; ++p) {
      n.left.push_back(p == 0 ? well : p);
      n.right.push_back(p == cells ? 0 : p + 1);
    }
    n.aperture.assign(cells + 1, width);
    n.flow.assign(cells + 1, 0.0);
    n.conductance.assign(cells + 1, 0.0);
    n.viscosity_share.assign(cells + 1, 1.0);
    follow();
  }
  // As step/stages.cpp does; pipes at the ends are half as long and lie in one pore alone.
  void follow() {
    const double cell = length / cells;
    for (std::size_t p = 0; p < n.left.size(); ++p) {
      const bool first = p == 0, last = p == cells;
      const auto l = static_cast<std::size_t>(first ? n.right[p] : n.left[p]),
                 r = static_cast<std::size_t>(last ? n.left[p] : n.right[p]);
      n.viscosity_share[p] = 1.0 + (ratio - 1.0) * 0.5 * (n.second_share_of(l) + n.second_share_of(r));
      n.conductance[p] = std::pow(width, 3) /
                         (12.0 * viscosity * n.viscosity_share[p] * (first || last ? 0.5 * cell : cell));
    }
  }
  // Pressure at the beginning by hand, with the front at x [m].
  [[nodiscard]] double by_hand(double x) const {
    return 12.0 * viscosity * rate / std::pow(width, 3) * (ratio * x + length - x);
  }
};

// A gel ten times as thick as water, then water again after it; increments in which fluid passes from a quarter of a pore to three of them.
TEST(SecondFluid, DisplacesTheFirstLikeAPiston) {
  for (const double pores : {0.25, 1.0, 3.0}) {
    Slot slot(10.0);
    Network& n = slot.n;
    Options o;
    o.fluid_bulk_modulus = 1e12;
    o.flow_scheme = choice(FlowScheme::implicit_scheme);
    FlowSolver flow(n, o);
    SecondFluid second(n);
    SecondFluidBooks books;
    std::vector<double> source(n.kind.size(), 0.0);
    source[Slot::well] = Slot::rate;
    const double all = Slot::width * Slot::length, step = pores * all / Slot::cells / Slot::rate;
    double gel = 0.0, worst = 0.0;
    for (int k = 1; k * step * Slot::rate < 0.7 * all; ++k) {
      const bool pumps_gel = k * step * Slot::rate <= 0.4 * all;
      const SecondFluid::Inlet inlet{Slot::well, pumps_gel ? 1.0 : 0.0};
      flow.advance(n, step, source);
      second.carry(n, {&inlet, 1}, step, books);
      gel += pumps_gel ? step * Slot::rate : 0.0;
      slot.follow();
      flow.advance(n, 1e-4 * step, source);  // the pressure of the front where it is now
      const double by_hand = slot.by_hand(gel / Slot::width);
      worst = std::max(worst, std::abs(n.pressure[Slot::well] / by_hand - 1.0));
      EXPECT_NEAR(books.from_wells, gel, 1e-6 * gel);  // the hole keeps what its fluid gives
      EXPECT_NEAR(second_fluid_in_rock(n) + books.leaked, books.from_wells, 1e-12 * gel);
    }
    std::printf("%g pores an increment: pressure at the inlet off by %.2g of the piston's at most\n", pores,
                worst);
    EXPECT_LT(worst, 0.01);
    for (std::size_t d = 1; d <= Slot::cells; ++d) {
      EXPECT_GE(n.second_share_of(d), 0.0);
      EXPECT_LE(n.second_content[d], n.fluid_in(d) * (1.0 + 1e-12));
    }
  }
}

// Flows of a host's making may go round: nothing is lost.
TEST(SecondFluid, IsKeptWhereFlowGoesRound) {
  Slot slot(2.0);
  Network& n = slot.n;
  n.left.push_back(40);
  n.right.push_back(20);
  n.flow.assign(n.left.size(), 1e-4);
  for (std::size_t p = 20; p < 40; ++p) n.flow[p] = 3e-4;  // 2e-4 of it goes round
  n.flow.back() = 2e-4;
  SecondFluid second(n);
  SecondFluidBooks books;
  const SecondFluid::Inlet inlet{Slot::well, 1.0};
  for (int k = 0; k < 50; ++k) second.carry(n, {&inlet, 1}, 1.0, books);
  EXPECT_NEAR(books.from_wells, 50e-4, 1e-15);
  EXPECT_NEAR(second_fluid_in_rock(n) + books.leaked, books.from_wells, 1e-12 * books.from_wells);
}

CaseDefinition two_fluids(SteppingMode mode) {
  CaseDefinition definition = quiet_case();
  Options& o = definition.options;
  o.flow_permeability = 1e-13;
  o.fluid_viscosity = 1e-3;
  o.fluid_second_viscosity = 5e-3;
  o.fluid_bulk_modulus = 2.2e9;
  o.stepping_mode = choice(mode);
  if (mode == SteppingMode::coupled) o.solver_kind = choice(SolverKind::quasi_static);
  o.stepping_flow_step = 1e7;
  WellOptions& well = definition.wells[0];
  well.control = WellControl::rate;
  well.rate = 1e-5;
  return definition;
}

void expect_books(const Simulation& s) {
  const SecondFluidBooks& b = s.model().accounts.second;
  EXPECT_NEAR(second_fluid_in_rock(s.network()) + b.leaked, b.from_wells + b.from_host, 1e-12 * b.from_wells);
  for (std::size_t d = 0; d < s.network().kind.size(); ++d) {
    EXPECT_GE(s.network().second_content[d], 0.0);
    EXPECT_LE(s.network().second_share_of(d), 1.0);
  }
}

TEST(SecondFluid, HasItsViscosityOnceAllIsDisplaced) {
  for (const auto mode : {SteppingMode::substep, SteppingMode::coupled}) {
    CaseDefinition definition = two_fluids(mode);
    definition.schedule = {{0, 4e7, 1e-5, choice(WellControl::rate), choice(ScheduleFluid::second)}};
    CaseDefinition alone = definition;  // that fluid from the start
    alone.options.fluid_viscosity = definition.options.fluid_second_viscosity;
    alone.options.fluid_second_viscosity = 0.0;
    alone.schedule.clear();
    Simulation s(definition, {}, {}), thick(alone, {}, {});
    const auto excess = [](const Simulation& of) {
      return of.network().pressure[of.wells()[0].place.domain] - 25e6;
    };
    for (int k = 0; k < 4; ++k) s.step();
    const double first = excess(s);
    EXPECT_EQ(second_fluid_in_rock(s.network()), 0.0);
    s.step();
    EXPECT_NEAR(s.model().accounts.second.from_wells, 100.0,
                1.0);                        // rate times step, less what the hole takes
    for (int k = 0; k < 200; ++k) s.step();  // a dozen pore volumes
    for (int k = 0; k < 8; ++k) thick.step();
    EXPECT_GT(excess(s), 4.0 * first);
    EXPECT_NEAR(excess(s), excess(thick), 0.01 * excess(thick));
    expect_books(s);
    EXPECT_GT(s.model().accounts.second.leaked, 1e4);
    // A host that takes some, and back out through the well.
    s.set_grid(HostGrid::regular(1, 1, {-100, -100}, {400, 400}, 0.0));
    set_cell_pressure(s, std::vector<double>{24.9e6}, {});
    EXPECT_LT(s.model().accounts.second.from_host, 0.0);
    expect_books(s);
    set_well_rate(s, 0, -1e-5);
    const double before = s.model().accounts.second.from_wells;
    for (int k = 0; k < 3; ++k) s.step();
    EXPECT_LT(s.model().accounts.second.from_wells, before - 100.0);
    expect_books(s);
  }
}

// Water that breaks the rock, then gel, then shut in: the books hold while facets come and open, and gel is in the fracture alone.
TEST(SecondFluid, FollowsAFractureThatGrows) {
  CaseDefinition definition = quiet_case();
  Options& o = definition.options;
  o.packing_disc_count = 800;
  make_linear(o);
  o.bond_tensile_strength = 5e6;
  o.bond_shear_strength = 60e6;
  o.bond_fracture_toughness = 5e6;
  o.fracture_law = choice(FractureLaw::facet);
  o.fracture_plane_modulus = 18.6e9;
  o.fracture_perforation_length = 3.0;
  o.stress_sigma_Hmax = 15e6;
  o.stress_sigma_hmin = 10e6;
  o.fluid_formation_pressure = 5e6;
  o.fluid_bulk_modulus = 2.2e9;
  o.fluid_viscosity = 1e-3;
  o.fluid_second_viscosity = 0.1;
  o.flow_permeability = 1e-17;
  o.flow_aperture_limit = 0.1;
  o.solver_kind = choice(SolverKind::quasi_static);
  o.stepping_mode = choice(SteppingMode::coupled);
  o.solver_smallest_step = 1e-2;
  o.solver_pressure_change = 0.3;
  o.solver_strength_overshoot = 0.1;
  o.stepping_flow_step = 5.0;
  WellOptions& well = definition.wells[0];
  well.radius = 4.0;
  well.control = WellControl::rate;
  well.rate = 5e-3;
  definition.schedule = {{0, 60.0, 5e-3, choice(WellControl::rate), choice(ScheduleFluid::second)},
                         {0, 100.0, 0.0, choice(WellControl::rate), choice(ScheduleFluid::same)}};
  Simulation s(definition, {}, {});
  for (int k = 0; k < 24; ++k) s.step();
  const Network& n = s.network();
  EXPECT_GT(s.engine().facets.all().size(), 10U);
  const double came = s.model().accounts.second.from_wells;
  EXPECT_GT(came, 0.1);
  EXPECT_LT(came, 0.2);  // rate times 40 s; the hole keeps the rest
  expect_books(s);
  double in_fracture = 0.0;
  for (std::size_t d = 1; d < n.kind.size(); ++d)
    in_fracture +=
        n.kind[d] == DomainKind::rock && !s.engine().facets.bonds_of(static_cast<std::int32_t>(d)).empty()
            ? n.second_content[d]
            : 0.0;
  EXPECT_GT(in_fracture, 0.9 * second_fluid_in_rock(n));
}

TEST(SecondFluid, IsInImagesAndHashes) {
  for (const auto mode : {SteppingMode::substep, SteppingMode::coupled}) {
    CaseDefinition definition = two_fluids(mode);
    definition.wells[0].fluid = choice(WellFluid::second);
    definition.schedule = {{0, 3e7, 1e-5, choice(WellControl::rate), choice(ScheduleFluid::first)}};
    Simulation s(definition, {}, {});
    for (int k = 0; k < 2; ++k) s.step();
    EXPECT_GT(second_fluid_in_rock(s.network()), 100.0);
    std::vector<std::byte> image(s.image_size());
    s.write_image(image);
    const auto now = s.state_hash();
    for (int k = 0; k < 2; ++k) s.step();
    EXPECT_EQ(s.wells()[0].drive.fluid, WellFluid::first);
    const auto later = s.state_hash();
    s.restore(image);
    EXPECT_EQ(s.state_hash(), now);
    EXPECT_EQ(s.wells()[0].drive.fluid, WellFluid::second);
    for (int k = 0; k < 2; ++k) s.step();
    EXPECT_EQ(s.state_hash(), later);
  }
}

TEST(SecondFluid, WeighsInPerforationsAndWellbore) {
  CaseDefinition definition = two_fluids(SteppingMode::coupled);
  Options& o = definition.options;
  o.fluid_second_density = 1500.0;
  o.stepping_flow_step = 10.0;
  WellOptions& well = definition.wells[0];
  well.rate = 1e-3;
  well.perforation_count = 4.0;
  well.perforation_diameter = 0.01;
  well.height = 20.0;
  well.depth = 1000.0;
  definition.schedule = {{0, 20.0, 1e-3, choice(WellControl::rate), choice(ScheduleFluid::second)}};
  Simulation s(definition, {}, {});
  const auto drop = [&] {
    return s.model().wellbores.front().pressure - s.network().pressure[s.wells()[0].place.domain];
  };
  for (int k = 0; k < 2; ++k) s.step();
  const double first = drop();
  s.step();
  EXPECT_NEAR(drop() / first, 1.5, 1e-3);
  EXPECT_NEAR(s.wells()[0].second_head, 1.5 * s.wells()[0].head, 1e-6);
}

TEST(SecondFluid, IsRefusedInWordsWhereItCannotBe) {
  const auto fault = [](const CaseDefinition& definition) {
    try {
      validate(definition);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CaseDefinition definition = two_fluids(SteppingMode::substep);
  EXPECT_EQ(fault(definition), "");
  definition.options.fluid_consistency = 1.0;
  definition.options.fluid_power_index = 0.5;
  EXPECT_NE(fault(definition).find("fluid.consistency = 0"), std::string::npos);
  definition = two_fluids(SteppingMode::substep);
  definition.options.fluid_second_viscosity = 0.0;
  EXPECT_EQ(fault(definition), "");
  definition.wells[0].fluid = choice(WellFluid::second);
  EXPECT_NE(fault(definition).find("give its fluid.second_viscosity"), std::string::npos);
  definition.wells[0].fluid = 0;
  definition.schedule = {{0, 1.0, 0.0, choice(WellControl::rate), choice(ScheduleFluid::second)}};
  EXPECT_NE(fault(definition).find("give its fluid.second_viscosity"), std::string::npos);
  definition.schedule.clear();
  definition.options.fluid_second_density = 1000.0;
  EXPECT_NE(fault(definition).find("is of no fluid"), std::string::npos);
  definition = two_fluids(SteppingMode::substep);
  definition.options.flow_scheme = choice(FlowScheme::off);
  definition.wells[0].control = WellControl::pressure;
  EXPECT_NE(fault(definition).find("flow.scheme = \"implicit\""), std::string::npos);
}

}  // namespace second_fluid_test
