// SPDX-License-Identifier: BSD-3-Clause
// A simulation's life: create, step, advance, ask how it stands, destroy.
#include <cmath>
#include <cstring>

#include "sim_support.hpp"

namespace sim_test {

using namespace testing_capi;

TEST(SimCreate, BuildsAModelAtRest) {
  const Sim sim(quiet_def());
  const auto state = state_of(sim);
  const auto setup = setup_of(sim);
  EXPECT_EQ(state.struct_size, static_cast<int32_t>(sizeof state));
  EXPECT_EQ(state.at_rest, 1);
  EXPECT_EQ(state.time, 0.0);
  EXPECT_EQ(state.step, 0);
  EXPECT_EQ(state.crack_count, 0);
  EXPECT_EQ(state.stop_reason, HFRAC_REASON_TARGET);
  EXPECT_GT(state.mechanical_step, 0.0);
  EXPECT_LE(state.force_ratio, 1e-4);
  EXPECT_EQ(setup.packed_discs, 500);
  EXPECT_EQ(state.disc_count, setup.packed_discs - setup.removed_in_wells - setup.removed_floaters);
  EXPECT_GT(setup.removed_in_wells, 5);
  EXPECT_NEAR(setup.porosity, 0.15, 1e-9);
  EXPECT_LE(setup.packing_residual, 1e-3);
  EXPECT_NEAR(setup.coordination, 2.0 * static_cast<double>(state.bond_count) / state.disc_count, 1e-12);
  EXPECT_NEAR(setup.permeability, 5.527e-15, 1e-20);
  EXPECT_GT(setup.zero_stress_aperture, 0.0);
  EXPECT_EQ(setup.strength_factor, 1.0);
  EXPECT_GT(setup.mean_radius, 1.5);
  EXPECT_LT(setup.mean_radius, 3.0);
  EXPECT_GT(setup.packing_seconds, 0.0);
  EXPECT_GE(setup.setup_seconds, setup.packing_seconds);
}

TEST(SimCreate, ItsBalanceStartsAtZero) {
  const Sim sim(quiet_def());
  const auto balance = balance_of(sim);
  for (const double value : {balance.injected_volume, balance.stored_volume, balance.leaked_volume,
                             balance.friction, balance.damping, balance.fracture, balance.kinetic}) {
    EXPECT_EQ(value, 0.0);
  }
  EXPECT_GT(balance.bond_elastic, 0.0);
  EXPECT_NEAR(balance.energy_error, 0.0, 1e-9 * balance.bond_elastic);
}

TEST(SimCreate, TheSameDefinitionGivesTheSameModel) {
  const Sim one(quiet_def()), same(quiet_def());
  EXPECT_EQ(hash_of(one), hash_of(same));
  hfrac::Definition def = quiet_def();
  def.model_seed = 2;
  const Sim other(def);
  EXPECT_NE(hash_of(one), hash_of(other));
}

TEST(SimCreate, GivesTheDefinitionBack) {
  hfrac::Definition def = quiet_def();
  ASSERT_EQ(hfrac_sim_def_set_str(&def, "title", "kept"), HFRAC_OK);
  const std::string text = written(def);
  const Sim sim(def);
  def = new_def();  // the caller's own: what becomes of it later changes nothing
  ASSERT_EQ(hfrac_sim_definition(sim, &def), HFRAC_OK);
  EXPECT_EQ(written(def), text);
  EXPECT_EQ(def.struct_size, static_cast<int32_t>(sizeof def));
  const Sim again(def);
  EXPECT_EQ(hash_of(again), hash_of(sim));
}

TEST(SimCreate, FailuresLeaveNullAndSayWhy) {
  int dummy = 0;
  auto* sim = reinterpret_cast<hfrac_sim*>(&dummy);
  EXPECT_EQ(hfrac_sim_create(nullptr, &sim), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(sim, nullptr);
  EXPECT_EQ(last_error(), "def is NULL.");

  hfrac::Definition def = quiet_def();
  EXPECT_EQ(hfrac_sim_create(&def, nullptr), HFRAC_ERR_ARGUMENT);
  def.packing_porosity = 0.5;
  sim = reinterpret_cast<hfrac_sim*>(&dummy);
  EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(sim, nullptr);
  EXPECT_EQ(last_error(), "packing.porosity = 0.5 is outside 0.08 to 0.2.");

  def = quiet_def();
  def.stress_sigma_hmin = 20e6;
  EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_MODEL);
  EXPECT_NE(last_error().find("stress.sigma_hmin = 2e7 Pa"), std::string::npos) << last_error();
  EXPECT_NE(last_error().find("fluid.formation_pressure = 2.5e7 Pa"), std::string::npos) << last_error();
  def = quiet_def();
  const int32_t size = def.struct_size;
  def.struct_size = 0;
  EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_EQ(sim, nullptr);
  def.struct_size = size;  // or its lists could not be freed
}

TEST(SimCreate, ASimulationWithoutWellsStandsStill) {
  hfrac::Definition def = quiet_def();
  def.well_count = 0;
  const Sim sim(def);
  int32_t wells = -1;
  ASSERT_EQ(hfrac_well_count(sim, &wells), HFRAC_OK);
  EXPECT_EQ(wells, 0);
  EXPECT_EQ(hfrac_step(sim, 2), HFRAC_OK);
  EXPECT_EQ(balance_of(sim).injected_volume, 0.0);
  EXPECT_EQ(state_of(sim).crack_count, 0);
}

TEST(SimCreate, ADryModelRuns) {
  hfrac::Definition def = cracking_def();
  ASSERT_EQ(hfrac_sim_def_set_str(&def, "flow.scheme", "off"), HFRAC_OK);
  const Sim sim(def);
  EXPECT_EQ(hfrac_step(sim, 2), HFRAC_OK) << last_error(sim);
  EXPECT_EQ(state_of(sim).step, 2);
  EXPECT_EQ(balance_of(sim).fluid_work, 0.0);
  EXPECT_EQ(balance_of(sim).leaked_volume, 0.0);
  EXPECT_EQ(setup_of(sim).permeability, 0.0);
}

TEST(SimDestroy, TakesNullAndMayComeTwice) {
  EXPECT_EQ(hfrac_sim_destroy(nullptr), HFRAC_OK);
  hfrac_sim* sim = nullptr;
  EXPECT_EQ(hfrac_sim_destroy(&sim), HFRAC_OK);
  const hfrac::Definition def = quiet_def();
  ASSERT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK);
  EXPECT_EQ(hfrac_sim_destroy(&sim), HFRAC_OK);
  EXPECT_EQ(sim, nullptr);
  EXPECT_EQ(hfrac_sim_destroy(&sim), HFRAC_OK);
}

TEST(SimStep, CountsStepsAndTime) {
  hfrac::Definition def = cracking_def();
  def.stepping_flow_step = 0.25;
  const Sim sim(def), twin(def);
  const int64_t before = hash_of(sim);
  ASSERT_EQ(hfrac_step(sim, 0), HFRAC_OK);
  EXPECT_EQ(hash_of(sim), before);
  ASSERT_EQ(hfrac_step(sim, 3), HFRAC_OK);
  const auto state = state_of(sim);
  EXPECT_EQ(state.step, 3);
  EXPECT_EQ(state.time, 0.75);
  EXPECT_EQ(state.at_rest, 1);
  EXPECT_LE(state.force_ratio, 1e-4);
  EXPECT_GT(state.cycles, 0);
  EXPECT_GT(state.crack_count, 0);
  EXPECT_EQ(state.crack_count, state.tensile_cracks + state.shear_cracks);
  EXPECT_GT(state.tip_distance, def.wells[0].radius);
  EXPECT_GT(state.flow_subcycles, 0);
  EXPECT_NE(hash_of(sim), before);
  // One by one is the same as at once.
  for (int k = 0; k < 3; ++k) ASSERT_EQ(hfrac_step(twin, 1), HFRAC_OK);
  EXPECT_EQ(hash_of(twin), hash_of(sim));
}

TEST(SimStep, BalancesClose) {
  const Sim sim(cracking_def());
  ASSERT_EQ(hfrac_step(sim, 4), HFRAC_OK);
  const auto balance = balance_of(sim);
  EXPECT_GT(balance.injected_volume, 0.0);
  EXPECT_GT(balance.fracture, 0.0);
  EXPECT_GT(balance.fluid_work, 0.0);
  EXPECT_EQ(balance.injected_volume, well_of(sim).injected_volume);
  EXPECT_NEAR(balance.injected_volume, balance.stored_volume + balance.leaked_volume + balance.fluid_error,
              1e-12);
  EXPECT_LE(std::abs(balance.fluid_error), 1e-6 * balance.injected_volume);
  EXPECT_LE(std::abs(balance.energy_error), 0.05 * balance.fluid_work);
}

TEST(SimStep, SaysWhenItDidNotComeToRest) {
  hfrac::Definition def = cracking_def();
  def.stepping_max_cycles = 20;
  const Sim sim(def);
  EXPECT_EQ(hfrac_step(sim, 1), HFRAC_NOT_AT_REST);
  EXPECT_EQ(state_of(sim).at_rest, 0);
  EXPECT_GT(state_of(sim).force_ratio, 1e-4);
  EXPECT_EQ(state_of(sim).step, 1);  // a note: the step was taken
  double reached = 0.0;
  int32_t reason = -1;
  EXPECT_EQ(hfrac_advance(sim, 2.0, &reached, &reason), HFRAC_NOT_AT_REST);
  EXPECT_EQ(reason, HFRAC_REASON_TARGET);
  EXPECT_EQ(reached, 2.0);
}

TEST(SimStep, RefusesNegativeCounts) {
  const Sim sim(quiet_def());
  const int64_t before = hash_of(sim), epoch = epoch_of(sim);
  EXPECT_EQ(hfrac_step(sim, -3), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(sim), "count = -3 is negative; give 0 or more steps.");
  EXPECT_EQ(hash_of(sim), before);
  EXPECT_EQ(epoch_of(sim), epoch);
}

TEST(SimStep, DivergenceLeavesTheStateBefore) {
  const Sim sim(cracking_def()), twin(cracking_def());
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  ASSERT_EQ(hfrac_step(twin, 1), HFRAC_OK);
  // More fluid than there are numbers for; its options' limits keep hfrac_step from that.
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  const Sight before = sight_of(sim);
  const int32_t status = hfrac_step_do(sim, 1e300);
  ASSERT_EQ(status, HFRAC_ERR_DIVERGED);
  EXPECT_NE(last_error(sim), "");
  expect_same(sight_of(sim), before);
  // And it is as good as new.
  ASSERT_EQ(hfrac_step_reject(sim), HFRAC_OK);
  expect_same(sight_of(sim), sight_of(twin));
  ASSERT_EQ(hfrac_step(sim, 2), HFRAC_OK);
  ASSERT_EQ(hfrac_step(twin, 2), HFRAC_OK);
  expect_same(sight_of(sim), sight_of(twin));
}

TEST(SimStep, NumbersThatOverflowAreNeverAccepted) {
  const Sim sim(cracking_def());
  ASSERT_EQ(hfrac_well_set_rate(sim, 0, 1e6), HFRAC_OK);
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  EXPECT_LT(hfrac_step_do(sim, 1e305), HFRAC_OK);
  EXPECT_TRUE(std::isfinite(balance_of(sim).fluid_error));
  EXPECT_TRUE(std::isfinite(well_of(sim).injected_volume));
}

TEST(SimStep, RealTimeRunsInWholeFlowSteps) {
  hfrac::Definition def = cracking_def();
  ASSERT_EQ(hfrac_sim_def_set_str(&def, "stepping.mode", "dynamic"), HFRAC_OK);
  def.stepping_flow_step = 1e-3;
  const Sim sim(def);
  const int64_t cycles = state_of(sim).cycles;
  ASSERT_EQ(hfrac_step(sim, 2), HFRAC_OK);
  const auto state = state_of(sim);
  EXPECT_DOUBLE_EQ(state.time, 2e-3);
  EXPECT_EQ(state.step, 2);
  EXPECT_NEAR(static_cast<double>(state.cycles - cycles), 2e-3 / state.mechanical_step, 2.0);
  EXPECT_GT(balance_of(sim).kinetic, 0.0);
}

TEST(SimAdvance, ReachesItsTargetInWholeSteps) {
  hfrac::Definition def = quiet_def();
  def.stepping_flow_step = 0.1;
  const Sim sim(def);
  double reached = -1.0;
  int32_t reason = -1;
  ASSERT_EQ(hfrac_advance(sim, 0.25, &reached, &reason), HFRAC_OK);
  EXPECT_EQ(reason, HFRAC_REASON_TARGET);
  EXPECT_NEAR(reached, 0.3, 1e-12);
  EXPECT_EQ(reached, state_of(sim).time);
  // Adding up tenths gives no second too many, however often.
  ASSERT_EQ(hfrac_advance(sim, 3.0, &reached, &reason), HFRAC_OK);
  EXPECT_EQ(state_of(sim).step, 30);
  // Nothing to do.
  const int64_t before = hash_of(sim);
  for (const double past : {3.0, 1.0, -5.0}) {
    ASSERT_EQ(hfrac_advance(sim, past, &reached, &reason), HFRAC_OK);
    EXPECT_EQ(reason, HFRAC_REASON_TARGET);
    EXPECT_EQ(reached, state_of(sim).time);
  }
  EXPECT_EQ(hash_of(sim), before);
}

// Ten tenths add up to less than one.
TEST(SimAdvance, ReachesWhatWholeStepsAddUpTo) {
  hfrac::Definition def = quiet_def();
  def.stepping_flow_step = 0.1;
  const Sim sim(def);
  double reached = 0.0;
  int32_t reason = -1, calls = 0;
  while (reached < 1.0 && calls < 3) {
    ASSERT_EQ(hfrac_advance(sim, 1.0, &reached, &reason), HFRAC_OK);
    ++calls;
  }
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(reached, 1.0);
  EXPECT_EQ(state_of(sim).step, 10);
}

TEST(SimAdvance, EndsAtATimeExactly) {
  hfrac::Definition def = quiet_def();
  def.stepping_flow_step = 0.1;
  const Sim sim(def);
  double reached = 0.0;
  int32_t reason = -1;
  for (const double target : {0.25, 0.3, 1.0, 1.7000000000000002, 2.0}) {
    ASSERT_EQ(hfrac_advance_to(sim, target, &reached, &reason), HFRAC_OK) << last_error(sim);
    EXPECT_EQ(reason, HFRAC_REASON_TARGET);
    EXPECT_EQ(reached, target);
    EXPECT_EQ(state_of(sim).time, target);
  }
  EXPECT_EQ(state_of(sim).step, 3 + 1 + 7 + 7 + 3);
  ASSERT_EQ(hfrac_advance_to(sim, 2.0, &reached, &reason), HFRAC_OK);
  EXPECT_EQ(hfrac_advance_to(sim, 1.9, &reached, &reason), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("lies before the model's time, 2 s"), std::string::npos) << last_error(sim);
  EXPECT_EQ(hfrac_advance_to(sim, std::nan(""), &reached, &reason), HFRAC_ERR_ARGUMENT);
}

TEST(SimAdvance, StopsAtCracks) {
  hfrac::Definition def = cracking_def();
  def.stop_cracks = 1;
  const Sim sim(def);
  double reached = 0.0;
  int32_t reason = -1;
  EXPECT_EQ(hfrac_advance(sim, 100.0, &reached, &reason), HFRAC_STOP_CONDITION);
  EXPECT_EQ(reason, HFRAC_REASON_CRACKS);
  EXPECT_EQ(reached, 1.0);
  EXPECT_EQ(state_of(sim).stop_reason, HFRAC_REASON_CRACKS);
  EXPECT_GE(state_of(sim).crack_count, 1);
  // Asked again it takes no step; hfrac_step does, since the host asks for so many.
  EXPECT_EQ(hfrac_advance(sim, 100.0, &reached, &reason), HFRAC_STOP_CONDITION);
  EXPECT_EQ(reason, HFRAC_REASON_CRACKS);
  EXPECT_EQ(reached, 1.0);
  EXPECT_EQ(hfrac_step(sim, 1), HFRAC_STOP_CONDITION);
  EXPECT_EQ(state_of(sim).step, 2);
  // It goes on when told to.
  EXPECT_EQ(hfrac_set_stop(sim, 0.0, 0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_stop(sim, 1.0, -1), HFRAC_ERR_ARGUMENT);
  ASSERT_EQ(hfrac_set_stop(sim, 1.0, 0), HFRAC_OK);
  EXPECT_EQ(state_of(sim).stop_reason, 0);
  EXPECT_GE(hfrac_advance(sim, 4.0, &reached, &reason), HFRAC_OK);
  EXPECT_EQ(reason, HFRAC_REASON_TARGET);
  EXPECT_EQ(reached, 4.0);
}

TEST(SimAdvance, StopsAtTheExtent) {
  hfrac::Definition def = cracking_def();
  def.stop_extent_fraction = 0.12;
  const Sim sim(def);
  double reached = 0.0;
  int32_t reason = -1;
  EXPECT_EQ(hfrac_advance(sim, 100.0, &reached, &reason), HFRAC_STOP_CONDITION);
  EXPECT_EQ(reason, HFRAC_REASON_EXTENT);
  EXPECT_LT(reached, 100.0);
  EXPECT_EQ(state_of(sim).stop_reason, HFRAC_REASON_EXTENT);
  EXPECT_GT(state_of(sim).tip_distance, 12.0);
}

TEST(SimAdvance, RefusesWhatIsNoTime) {
  const Sim sim(quiet_def());
  double reached = -1.0;
  int32_t reason = -1;
  for (const double target : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_EQ(hfrac_advance(sim, target, &reached, &reason), HFRAC_ERR_ARGUMENT);
    EXPECT_NE(last_error(sim).find("target"), std::string::npos);
    EXPECT_NE(last_error(sim).find("not a finite number"), std::string::npos);
  }
  EXPECT_EQ(hfrac_advance(sim, 1.0, nullptr, &reason), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(sim), "reached is NULL.");
  EXPECT_EQ(hfrac_advance(sim, 1.0, &reached, nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(sim), "reason is NULL.");
  EXPECT_EQ(reached, -1.0);
  EXPECT_EQ(reason, -1);
  EXPECT_EQ(state_of(sim).step, 0);
}

TEST(SimErrors, StayWithTheirSimulation) {
  const Sim one(quiet_def()), other(quiet_def());
  EXPECT_EQ(last_error(one), "");
  EXPECT_EQ(hfrac_step(one, -1), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_abi_version(nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(one), "count = -1 is negative; give 0 or more steps.");
  EXPECT_EQ(last_error(other), "");
  EXPECT_EQ(last_error(), "abi is NULL.");
  EXPECT_EQ(hfrac_step(one, 1), HFRAC_OK);  // success does not wipe it out
  EXPECT_EQ(last_error(one), "count = -1 is negative; give 0 or more steps.");
}

// What a caller compiled against an older header sees of a struct, and one compiled against a newer one.
template <class Struct, class Call>
void expect_any_size(Call call) {
  Struct whole{};
  EXPECT_EQ(call(&whole), HFRAC_ERR_STRUCT_SIZE);
  whole.struct_size = 12;
  EXPECT_EQ(call(&whole), HFRAC_ERR_STRUCT_SIZE);
  whole.struct_size = sizeof whole;
  ASSERT_EQ(call(&whole), HFRAC_OK);

  std::vector<unsigned char> memory(sizeof(Struct) + 16, 0xEE);
  auto* part = reinterpret_cast<Struct*>(memory.data());
  constexpr int32_t older = sizeof(Struct) - 16;
  part->struct_size = older;
  ASSERT_EQ(call(part), HFRAC_OK);
  EXPECT_EQ(part->struct_size, older);
  EXPECT_EQ(std::memcmp(memory.data() + 4, reinterpret_cast<unsigned char*>(&whole) + 4, older - 4), 0);
  EXPECT_EQ(memory[older], 0xEE);

  constexpr int32_t newer = sizeof(Struct) + 8;
  part->struct_size = newer;
  ASSERT_EQ(call(part), HFRAC_OK);
  EXPECT_EQ(part->struct_size, newer);
  EXPECT_EQ(memory[sizeof(Struct)], 0);
  EXPECT_EQ(memory[newer - 1], 0);
  EXPECT_EQ(memory[newer], 0xEE);
}

TEST(SimStructs, MayBeOlderOrNewer) {
  const Sim sim(cracking_def());
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  expect_any_size<hfrac_sim_state>([&](auto* to) { return hfrac_sim_get_state(sim, to); });
  expect_any_size<hfrac_setup_report>([&](auto* to) { return hfrac_sim_get_setup(sim, to); });
  expect_any_size<hfrac_balance>([&](auto* to) { return hfrac_get_balance(sim, to); });
  expect_any_size<hfrac_solver_report>([&](auto* to) { return hfrac_sim_get_solver(sim, to); });
  expect_any_size<hfrac_well_state>([&](auto* to) { return hfrac_well_get(sim, 0, to); });
  expect_any_size<hfrac_field_desc>([&](auto* to) { return hfrac_field_info(sim, HFRAC_DISC_RADIUS, to); });
  std::vector<unsigned char> memory(sizeof(hfrac_sim_def), 0xEE);
  auto* def = reinterpret_cast<hfrac_sim_def*>(memory.data());
  constexpr int32_t older = offsetof(hfrac_sim_def, title);
  ASSERT_EQ(hfrac_sim_def_init(def, older), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_definition(sim, def), HFRAC_OK) << last_error(sim);
  EXPECT_EQ(def->struct_size, older);
  EXPECT_EQ(def->well_count, 1);
  EXPECT_EQ(def->wells[0].pressure, 60e6);
  EXPECT_EQ(memory[older], 0xEE);
  EXPECT_EQ(hfrac_sim_def_free(def), HFRAC_OK);
}

}  // namespace sim_test
