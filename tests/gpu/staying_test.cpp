// SPDX-License-Identifier: BSD-3-Clause
// State that stays on the device between steps: whoever asks at whatever moment gets that of the processor, to the last bit, though the
// host's own copies of what is away were made worthless; and how many bytes a step sends and fetches.
#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "emulated.hpp"
#include "options/choices.hpp"
#include "small_case.hpp"
#include "step/impose.hpp"

namespace {
using namespace hfrac;
using testing_unit::choice;

struct Named {
  const char* name;
  std::function<void(CaseDefinition&)> change;
  friend std::ostream& operator<<(std::ostream& out, const Named& named) { return out << named.name; }
};

// Models of two tiles and more; each has something else that the host might read too late.
const std::vector<Named> models = {
    {"cracks_behind_walls", [](CaseDefinition&) {}},
    {"iterative_flow",
     [](CaseDefinition& d) { d.options.flow_solver = choice(FlowMatrixSolver::iterative); }},
    {"servo_walls_under_stress",
     [](CaseDefinition& d) {
       Options& o = d.options;
       o.stress_convention = choice(StressConvention::total);
       o.boundary_walls_after_equilibration = choice(WallsAfterEquilibration::servo);
       o.stress_sigma_Hmax = 32e6;
       o.stress_sigma_hmin = 30e6;
       d.wells[0].pressure = 90e6;
     }},
    {"free_edges_under_stress",
     [](CaseDefinition& d) {
       Options& o = d.options;
       o.stress_convention = choice(StressConvention::total);
       o.boundary_kind = choice(BoundaryKind::stress);
       o.stress_sigma_Hmax = o.stress_sigma_hmin = 30e6;
       d.wells[0].pressure = 90e6;
     }},
    {"dry", [](CaseDefinition& d) { d.options.flow_scheme = choice(FlowScheme::off); }},
    {"real_motion",
     [](CaseDefinition& d) {
       d.options.stepping_mode = choice(SteppingMode::dynamic);
       d.options.stepping_flow_step = 1e-3;
     }},
    {"softening", [](CaseDefinition& d) { d.options.bond_fracture_energy = 3e6; }},
    {"flat_contacts", [](CaseDefinition& d) { d.options.contact_shape = choice(ContactShape::flat); }},
    {"smooth_joint",
     [](CaseDefinition& d) {
       JointOptions joint;
       joint.x1 = 20.0;
       joint.y1 = 30.0;
       joint.x2 = 80.0;
       joint.y2 = 65.0;
       joint.friction = 0.1;
       joint.state = choice(JointState::smooth_broken);
       d.joints.push_back(joint);
     }},
    {"heat",
     [](CaseDefinition& d) {
       Options& o = d.options;
       o.thermal_mode = choice(ThermalMode::transport);
       o.thermal_expansion = 1e-5;
       o.thermal_fluid_temperature = o.thermal_rock_temperature - 100.0;
     }},
    {"heat_that_water_feels",
     [](CaseDefinition& d) {
       Options& o = d.options;
       o.fluid_kind = choice(FluidKind::water);
       o.bond_tensile_strength = o.bond_shear_strength = 1e12;  // or it breaks in every step
       o.thermal_mode = choice(ThermalMode::transport);
       o.thermal_expansion = 1e-5;
       o.thermal_fluid_temperature = o.thermal_rock_temperature - 100.0;
     }},
};

CaseDefinition definition_of(const Named& model, RunDevice device) {
  CaseDefinition d = testing_unit::cracking_case();
  d.options.packing_disc_count = 1200;
  d.options.stepping_flow_step = 1e-2;
  d.options.stepping_max_cycles = 2000;
  model.change(d);
  d.options.run_device = choice(device);
  return d;
}

class StateOnADevice : public testing::TestWithParam<Named> {};

TEST_P(StateOnADevice, IsTheProcessorsWheneverSomebodyAsks) {
  Simulation here(definition_of(GetParam(), RunDevice::cpu), {}, {}),
      there(definition_of(GetParam(), RunDevice::gpu), {}, {});
  ASSERT_EQ(here.state_hash(), there.state_hash());
  there.engine().mechanics->spoil_what_is_away();
  Random random(7);
  const auto image_of = [](const Simulation& sim) {
    std::vector<std::byte> image(sim.image_size());
    sim.write_image(image);
    return image;
  };
  int stayed = 0;
  for (int step = 0; step < 8; ++step) {
    here.step();
    there.step();
    stayed += there.engine_as_is().mechanics->is_away() ? 1 : 0;
    ASSERT_EQ(here.network().pressure, there.network().pressure) << step;
    ASSERT_EQ(here.network().aperture, there.network().aperture) << step;
    ASSERT_EQ(here.cracks().size(), there.cracks().size()) << step;
    switch (static_cast<int>(8.0 * random.uniform())) {
      case 0:
        ASSERT_EQ(here.state_hash(), there.state_hash()) << step;
        break;
      case 1:
        ASSERT_EQ(image_of(here), image_of(there)) << step;
        break;
      case 2:
        ASSERT_EQ(here.assembly().vx, there.assembly().vx) << step;
        ASSERT_EQ(here.assembly().slip, there.assembly().slip) << step;
        break;
      case 3:
        ASSERT_EQ(here.balance().damping, there.balance().damping) << step;
        ASSERT_EQ(here.balance().contact_elastic, there.balance().contact_elastic) << step;
        break;
      default:
        break;
    }
  }
  // Of motion that carries much energy the host checks the balance after every step.
  if (here.options().stepping_mode != choice(SteppingMode::dynamic)) {
    EXPECT_GT(stayed, 0) << "state never stayed on the device";
  }
  EXPECT_EQ(here.state_hash(), there.state_hash());
}

TEST_P(StateOnADevice, ComesBackWithAStepThatIsStoppedOrTriedAgain) {
  Simulation here(definition_of(GetParam(), RunDevice::cpu), {}, {}),
      there(definition_of(GetParam(), RunDevice::gpu), {}, {});
  there.engine().mechanics->spoil_what_is_away();
  for (auto* sim : {&here, &there}) {
    sim->step();
    set_well_pressure(*sim, 0, 95e6);
    const bool stopped = sim->step([] { return true; }).stopped;
    EXPECT_TRUE(stopped || sim->options().flow_scheme == choice(FlowScheme::off)) << "dry rock rests at once";
    sim->step();
    sim->begin_step();
    sim->try_step(2e-2);
    sim->try_step(5e-3);
    sim->accept_step();
    sim->begin_step();
    sim->try_step(1e-2);
    sim->reject_step();
    sim->step();
    // Several steps in one that is open, the first try and one behind it stopped, unless rock rests at once; other loads.
    set_well_pressure(*sim, 0, 97e6);
    sim->begin_step();
    sim->try_step(1e-2, [] { return true; });
    sim->try_step(1e-2);
    sim->step();
    sim->step([] { return true; });
    set_well_pressure(*sim, 0, 90e6);
    sim->try_step(1e-2);
    sim->reject_step();
    sim->step();
  }
  EXPECT_EQ(here.state_hash(), there.state_hash());
}

INSTANTIATE_TEST_SUITE_P(Models, StateOnADevice, testing::ValuesIn(models),
                         [](const auto& which) { return which.param.name; });

// A quiet step of a wet model: there go contents, pressures and stiffnesses of pores, and back come displacements, pressures and volumes; the
// rest is what batches tell, which does not grow with the model's discs but with its tiles.
TEST(BytesOfAStep, AreThoseOfTheFluidAndOfDisplacements) {
  if (emulated::bytes().sent < 0) GTEST_SKIP() << "not the emulated driver";
  CaseDefinition d = testing_unit::quiet_case();
  d.options.packing_disc_count = 1500;
  d.options.run_device = choice(RunDevice::gpu);
  Simulation sim(d, {}, {});
  sim.step();
  const auto discs = sim.engine_as_is().model.assembly.disc_count();
  const auto domains = sim.network().domain_count();
  const auto& arrays = sim.engine_as_is().mechanics->arrays();
  const auto cost_of = [&](const auto& take) {
    const auto before = emulated::bytes();
    const auto cycles = sim.engine_as_is().model.clock.cycles;
    take();
    const auto after = emulated::bytes();
    const auto batches =
        (sim.engine_as_is().model.clock.cycles - cycles + 19) / 20 + 1;  // and the evaluation
    const auto sums = static_cast<long long>(
        sizeof(TileSums) * static_cast<std::size_t>(4 * arrays.tile_count + arrays.pair_count) +
        6 * sizeof(double) * static_cast<std::size_t>(arrays.tile_count));
    constexpr long long walls = 512;  // and the stage at which to stop
    return std::pair{after.sent - before.sent - batches * walls,
                     after.fetched - before.fetched - batches * (sums + walls)};
  };
  const auto step = [&] { return cost_of([&] { sim.step(); }); };
  const auto quiet = step();
  std::cout << discs << " discs, " << domains << " pores, beside what batches tell: sent " << quiet.first
            << " bytes, fetched " << quiet.second << '\n';
  EXPECT_LE(quiet.first, 8 * 3 * domains);
  EXPECT_GE(quiet.first, 8 * 2 * domains) << "the fluid's part is sent";
  EXPECT_LE(quiet.second, 8 * (2 * discs + 2 * domains) + 16 * arrays.tile_count);
  const auto opened = cost_of([&] {
    sim.begin_step();
    sim.try_step(sim.next_step());
    sim.accept_step();
  });
  EXPECT_LE(opened.first, 8 * 3 * domains);
  EXPECT_LE(opened.second, 8 * (2 * discs + 2 * domains) + 16 * arrays.tile_count);
  const auto hash = sim.state_hash();  // all of it comes home, and goes back
  const auto after_a_look = step();
  EXPECT_GT(after_a_look.first, 2 * quiet.first);
  EXPECT_NE(hash, sim.state_hash());
}

}  // namespace
