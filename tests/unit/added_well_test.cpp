// SPDX-License-Identifier: BSD-3-Clause
// A well added to a living simulation: it changes nothing until it is driven, then fluid, heat and energy stay in the books, and it comes
// and goes with the state.
#include "step/added_well.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "flow/second_fluid.hpp"
#include "fluid_in_rock.hpp"
#include "small_case.hpp"

namespace added_well_test {

using namespace testing_unit;

constexpr Vec2 place{75.0, 60.0};

double pressure_of(const Simulation& s, std::size_t well) {
  return s.network().pressure[s.wells()[well].place.domain];
}

std::vector<std::byte> image_of(const Simulation& s) {
  std::vector<std::byte> image(s.image_size());
  s.write_image(image);
  return image;
}

void steps(Simulation& s, int count) {
  for (int k = 0; k < count; ++k) s.step();
}

// The ways to step, with what each needs.
struct Way {
  const char* name;
  SteppingMode mode;
  SolverKind solver;
  FlowScheme flow;
};
constexpr Way ways[] = {
    {"real time", SteppingMode::dynamic, SolverKind::explicit_solver, FlowScheme::implicit_scheme},
    {"to rest", SteppingMode::substep, SolverKind::explicit_solver, FlowScheme::explicit_scheme},
    {"to rest, quasi-static", SteppingMode::substep, SolverKind::quasi_static, FlowScheme::implicit_scheme},
    {"coupled", SteppingMode::coupled, SolverKind::quasi_static, FlowScheme::implicit_scheme},
};

CaseDefinition case_of(const Way& way) {
  CaseDefinition definition = quiet_case();
  Options& o = definition.options;
  o.stepping_mode = choice(way.mode);
  o.solver_kind = choice(way.solver);
  o.flow_scheme = choice(way.flow);
  o.stepping_flow_step = way.mode == SteppingMode::dynamic ? 0.02 : 0.5;
  definition.wells[0].pressure = 25e6;  // its fluid at rest
  return definition;
}

void expect_books_close(const Simulation& s) {
  const Balance b = s.balance();
  double injected = 0.0, moved = std::abs(b.stored) + std::abs(b.leaked);
  for (const auto& well : s.wells()) {
    injected += well.injected;
    moved += std::abs(well.injected);
  }
  EXPECT_GT(moved, 0.0);
  EXPECT_LE(std::abs(b.injected - injected), 1e-12 * moved);
  EXPECT_LE(std::abs(b.fluid_error), 1e-12 * moved);
}

TEST(AddedWell, ChangesNothingUntilItIsDriven) {
  for (const Way& way : ways) {
    SCOPED_TRACE(way.name);
    Simulation with(case_of(way), {}, {}), without(case_of(way), {}, {});
    steps(with, 1);
    steps(without, 1);
    EXPECT_EQ(add_well(with, place), 1U);
    steps(with, 2);
    steps(without, 2);
    EXPECT_EQ(with.network().pressure, without.network().pressure);
    EXPECT_EQ(with.network().content, without.network().content);
    EXPECT_EQ(with.assembly().ux, without.assembly().ux);
    EXPECT_EQ(with.balance().injected, without.balance().injected);
    EXPECT_EQ(with.wells()[1].injected, 0.0);
    EXPECT_NE(with.state_hash(), without.state_hash());
  }
}

TEST(AddedWell, IsDrivenAsAnyOther) {
  for (const Way& way : ways) {
    SCOPED_TRACE(way.name);
    Simulation s(case_of(way), {}, {});
    steps(s, 1);
    const auto w = add_well(s, place);
    const double rate = 2e-4 / s.options().stepping_flow_step;  // m2 a step, over the step
    set_well_rate(s, w, rate);
    steps(s, 2);
    EXPECT_NEAR(s.wells()[w].injected, 4e-4, 1e-15);
    EXPECT_NEAR(s.wells()[w].rate, rate, 1e-9 * rate);
    EXPECT_GT(pressure_of(s, w), 25e6);
    expect_books_close(s);
    set_well_pressure(s, w, 27e6);
    steps(s, 2);
    EXPECT_EQ(pressure_of(s, w), 27e6);
    expect_books_close(s);
    set_well_ramp(s, w, 23e6, 1e6);
    steps(s, 3);
    EXPECT_NEAR(pressure_of(s, w), 24e6, 1e-6);
    EXPECT_LT(s.wells()[w].rate, 0.0);  // below the formation's: it produces
    expect_books_close(s);
    set_well_rate(s, w, 0.0);
    const double injected = s.wells()[w].injected;
    steps(s, 2);
    EXPECT_NEAR(s.wells()[w].injected, injected, 1e-15);
    EXPECT_GT(pressure_of(s, w), 24e6);  // fills again
    expect_books_close(s);
    const Balance b = s.balance();
    EXPECT_EQ(b.energy_checked, way.solver == SolverKind::explicit_solver);
    if (b.energy_checked) {
      EXPECT_LE(std::abs(b.energy_error), 1e-3 * (std::abs(b.fluid_work) + std::abs(b.boundary_work)));
    }
  }
}

TEST(AddedWell, FollowsASchedule) {
  Simulation s(quiet_case(), {}, {});
  const auto w = add_well(s, place);
  const double step = s.options().stepping_flow_step;
  set_well_schedule(s, w, {{static_cast<std::int64_t>(w), 0.5 * step, 27e6, choice(WellControl::pressure)}});
  EXPECT_DOUBLE_EQ(s.next_step(), 0.5 * step);
  s.step();
  EXPECT_LT(pressure_of(s, w), 27e6);
  s.step();
  EXPECT_EQ(pressure_of(s, w), 27e6);
  expect_books_close(s);
}

// A state taken after wells were added makes a simulation built from the same case go on bit for bit, whatever wells it had.
TEST(AddedWell, ComesAndGoesWithTheState) {
  for (const Way& way : ways) {
    SCOPED_TRACE(way.name);
    Simulation s(case_of(way), {}, {});
    steps(s, 1);
    const auto before = image_of(s);
    const auto hash_before = s.state_hash();
    set_well_pressure(s, add_well(s, place), 28e6);
    set_well_rate(s, add_well(s, {20.0, 30.0}), 1e-5);
    steps(s, 1);
    const auto with = image_of(s);
    const auto hash_with = s.state_hash();
    steps(s, 1);
    const auto hash_after = s.state_hash();

    Simulation fresh(case_of(way), {}, {});
    fresh.restore(with);
    ASSERT_EQ(fresh.wells().size(), 3U);
    EXPECT_EQ(fresh.state_hash(), hash_with);
    EXPECT_EQ(fresh.wells()[1].place.domain, s.wells()[1].place.domain);
    EXPECT_TRUE(fresh.network().is_well(static_cast<std::size_t>(fresh.wells()[2].place.domain)));
    EXPECT_EQ(fresh.definition().wells.size(), 1U);  // as it was built
    steps(fresh, 1);
    EXPECT_EQ(fresh.state_hash(), hash_after);

    s.restore(before);
    ASSERT_EQ(s.wells().size(), 1U);
    EXPECT_EQ(s.state_hash(), hash_before);
    EXPECT_TRUE(s.network().fed.empty());
    steps(s, 1);
    s.restore(with);
    steps(s, 1);
    EXPECT_EQ(s.state_hash(), hash_after);
    EXPECT_EQ(add_well(s, {50.0, 80.0}), 3U);
    steps(s, 1);
  }
}

TEST(AddedWell, StaysWhenAStepIsTakenBack) {
  Simulation s(case_of(ways[3]), {}, {});
  set_well_pressure(s, add_well(s, place), 28e6);
  const auto hash = s.state_hash();
  EXPECT_TRUE(s.step([] { return true; }).stopped);
  EXPECT_EQ(s.state_hash(), hash);
  s.begin_step();
  set_well_pressure(s, 1, 26e6);
  s.try_step(1.0);
  EXPECT_EQ(pressure_of(s, 1), 26e6);
  s.try_step(0.5);
  EXPECT_EQ(pressure_of(s, 1), 26e6);
  EXPECT_THROW(add_well(s, {20.0, 30.0}), Error);  // a rejection would take it away
  s.reject_step();
  EXPECT_EQ(s.state_hash(), hash);
  ASSERT_EQ(s.wells().size(), 2U);
  s.step();
  EXPECT_EQ(pressure_of(s, 1), 28e6);
  add_well(s, {20.0, 30.0});
}

// In stressed rock that breaks, with both laws of fracture and every way to step.
TEST(AddedWell, BreaksTheRockAndItsFractureNamesIt) {
  for (const auto law : {FractureLaw::bond, FractureLaw::facet}) {
    for (const Way& way : ways) {
      const bool facets = law == FractureLaw::facet;
      if (facets && way.mode == SteppingMode::substep && way.solver == SolverKind::quasi_static) continue;
      SCOPED_TRACE(std::string(way.name) + (facets ? ", facets" : ", bonds"));
      CaseDefinition definition = case_of(way);
      Options& o = definition.options;
      make_linear(o);
      o.packing_disc_count = 600;
      o.stress_sigma_Hmax = 22e6;
      o.stress_sigma_hmin = 20e6;
      o.fluid_formation_pressure = definition.wells[0].pressure = 19.5e6;
      definition.wells[0].radius = 6.0;
      o.fracture_law = choice(law);
      o.fracture_plane_modulus = facets ? 18.6e9 : 0.0;
      o.bond_fracture_toughness = facets ? 3e6 : 0.0;
      o.bond_tensile_strength = 5e6;
      o.bond_shear_strength = 60e6;
      o.fluid_viscosity = 0.01;
      o.flow_scheme = choice(FlowScheme::implicit_scheme);
      o.stepping_force_ratio = 1e-4;
      o.stepping_max_cycles = 20000;
      Simulation s(definition, {}, {});
      ASSERT_TRUE(s.cracks().empty());
      set_well_rate(s, add_well(s, {75.0, 50.0}), 2.5e-3 / o.stepping_flow_step);
      for (int k = 0; k < 80 && s.cracks().empty(); ++k) s.step();
      ASSERT_FALSE(s.cracks().empty());
      const auto fractures = s.fractures();
      EXPECT_TRUE(
          std::any_of(fractures.begin(), fractures.end(), [](const Fracture& f) { return f.well == 1; }));
      expect_books_close(s);
      const auto image = image_of(s);
      steps(s, 2);
      const auto hash = s.state_hash();
      s.restore(image);
      steps(s, 2);
      EXPECT_EQ(s.state_hash(), hash);
    }
  }
}

// Its pore is then the joint's, which stores by the joint's opening.
TEST(AddedWell, MayLieInAJointThatConducts) {
  for (const Way& way : ways) {
    SCOPED_TRACE(way.name);
    CaseDefinition definition = case_of(way);
    JointOptions joint;
    joint.x1 = joint.x2 = 75.0;
    joint.y1 = 30.0;
    joint.y2 = 80.0;
    joint.state = choice(JointState::smooth_broken);
    joint.aperture = 1e-4;
    joint.friction = 0.6;
    definition.joints.push_back(joint);
    Simulation s(definition, {}, {});
    const auto w = add_well(s, place);
    const auto d = static_cast<std::size_t>(s.wells()[w].place.domain);
    ASSERT_EQ(s.network().joint_pore[d], 1);
    set_well_pressure(s, w, 27e6);
    steps(s, 2);
    EXPECT_EQ(pressure_of(s, w), 27e6);
    EXPECT_GT(s.wells()[w].rate, 0.0);
    const double rate = 5e-4 / s.options().stepping_flow_step;
    set_well_rate(s, w, rate);
    steps(s, 2);
    EXPECT_NEAR(s.wells()[w].rate, rate, 1e-9 * rate);
    expect_books_close(s);
  }
}

TEST(AddedWell, HeatOfWhatItInjectsIsInTheBooks) {
  CaseDefinition definition = quiet_case();
  definition.options.thermal_mode = choice(ThermalMode::transport);
  definition.options.thermal_rock_temperature = 450.0;
  definition.options.thermal_fluid_temperature = 350.0;
  definition.options.stepping_flow_step = 1e5;
  Simulation s(definition, {}, {});
  steps(s, 1);
  const auto w = add_well(s, place);
  const auto close = [&] {
    const HeatBalance b = heat_balance_of(s.engine());
    EXPECT_LT(b.from_wells, 0.0);
    EXPECT_LE(std::abs(b.error), 1e-9 * std::abs(b.from_wells));
    return b.from_wells;
  };
  const double before = close();
  set_well_temperature(s, w, 300.0);
  set_well_pressure(s, w, 29e6);
  steps(s, 3);
  EXPECT_LT(close(), before);
  EXPECT_EQ(s.model().heat->fluid[s.wells()[w].place.domain], 300.0);
  const auto image = image_of(s);
  const auto hash = s.state_hash();
  Simulation fresh(definition, {}, {});
  fresh.restore(image);
  EXPECT_EQ(fresh.state_hash(), hash);
  steps(fresh, 1);
  steps(s, 1);
  EXPECT_EQ(fresh.state_hash(), s.state_hash());
  set_well_pressure(s, w, 22e6);  // produces: as warm as what flows in
  steps(s, 3);
  EXPECT_GT(s.model().heat->fluid[s.wells()[w].place.domain], 300.0);
  close();
}

TEST(AddedWell, TheSecondFluidIsInTheBooks) {
  CaseDefinition definition = case_of(ways[3]);
  definition.options.fluid_second_viscosity = 5e-3;
  definition.options.stepping_flow_step = 1e4;
  definition.schedule = {{0, 1.0, 29e6, choice(WellControl::pressure), choice(ScheduleFluid::second)}};
  Simulation s(definition, {}, {});
  steps(s, 4);
  std::size_t richest = 1;
  for (std::size_t d = 1; d < s.network().kind.size(); ++d)
    if (s.network().is_own(d) && s.network().second_content[d] > s.network().second_content[richest])
      richest = d;
  const double held = s.network().second_content[richest], in_rock = second_fluid_in_rock(s.network());
  ASSERT_GT(held, 0.0);
  const auto w = add_well(s, s.network().centroid[richest]);
  EXPECT_NEAR(second_fluid_in_rock(s.network()), in_rock - held, 1e-12 * in_rock);
  const auto expect_books = [&] {
    const SecondFluidBooks& b = s.model().accounts.second;
    EXPECT_NEAR(second_fluid_in_rock(s.network()) + b.leaked, b.from_wells + b.from_host, 1e-12 * in_rock);
  };
  expect_books();
  for (const double pressure : {22e6, 27e6}) {  // it takes both fluids out, and puts the first in
    set_well_pressure(s, w, pressure);
    steps(s, 3);
    expect_books();
  }
}

TEST(AddedWell, KeepsItsPressureWhenAHostSetsThatOfCells) {
  Simulation s(quiet_case(), {}, {});
  set_well_pressure(s, add_well(s, place), 28e6);
  s.set_grid(HostGrid::regular(2, 2, {0.0, 0.0}, {50.0, 50.0}, 0.0));
  s.step();
  std::vector<double> wanted(4, 25e6), added(4);
  set_cell_pressure(s, wanted, added);
  EXPECT_EQ(pressure_of(s, 1), 28e6);
  for (const auto& cell : report_cells(s, Upscaling::oda)) EXPECT_NEAR(cell.pressure, 25e6, 1.0);
  s.step();
  expect_books_close(s);
}

std::string refusal(Simulation& s, Vec2 at) {
  const auto hash = s.state_hash();
  std::string text;
  try {
    add_well(s, at);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::argument);
    text = error.what();
  }
  EXPECT_EQ(s.state_hash(), hash);
  return text;
}

TEST(AddedWell, IsRefusedInWords) {
  Simulation s(quiet_case(), {}, {});
  for (const Vec2 outside : {Vec2{-1.0, 50.0}, Vec2{50.0, 100.0}, Vec2{1e6, 1e6}})
    EXPECT_NE(refusal(s, outside).find("outside the rock"), std::string::npos);
  for (const Vec2 hole : {Vec2{50.0, 50.0}, Vec2{58.0, 50.0}})
    EXPECT_NE(refusal(s, hole).find("well 0, at (50, 50) m, is there already"), std::string::npos);
  EXPECT_NE(refusal(s, {NAN, 50.0}).find("finite"), std::string::npos);
  EXPECT_NE(refusal(s, {50.0, INFINITY}).find("finite"), std::string::npos);
  add_well(s, place);
  EXPECT_NE(refusal(s, place).find("well 1, at"), std::string::npos);
  CaseDefinition dry = quiet_case();
  dry.options.flow_scheme = choice(FlowScheme::off);
  Simulation without_fluid(dry, {}, {});
  EXPECT_NE(refusal(without_fluid, place).find("flow.scheme"), std::string::npos);
}

// What no image may say of an added well, behind a good checksum.
TEST(AddedWell, OfADamagedStateIsRefused) {
  Simulation s(quiet_case(), {}, {});
  add_well(s, place);
  add_well(s, {20.0, 30.0});
  const auto hash = s.state_hash();
  const auto good = image_of(s);
  for (const std::int32_t wrong : {0, s.wells()[0].place.domain, s.wells()[1].place.domain}) {
    s.engine().model.wells[2].place.domain = wrong;
    const auto bad = image_of(s);
    s.restore(good);
    EXPECT_THROW(s.restore(bad), Error);
    EXPECT_EQ(s.state_hash(), hash);
  }
}

}  // namespace added_well_test
