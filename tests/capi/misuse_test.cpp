// SPDX-License-Identifier: BSD-3-Clause
// Every function on a simulation used wrongly: no handle, a handle that is none, NULL, structs never sized, a
// poisoned simulation. None may crash; sanitizer builds run this too.
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <stdexcept>

#include "sim_support.hpp"

namespace misuse_test {

using namespace testing_capi;

// Every function that takes a simulation, with arguments that are good otherwise.
struct Call {
  const char* name;
  std::function<int32_t(hfrac_sim*)> run;
};
std::vector<Call> all_calls() {
  static hfrac::Definition def;
  static hfrac_sim_state state;
  static hfrac_setup_report setup;
  static hfrac_balance balance;
  static hfrac_solver_report solver;
  static hfrac_well_state well;
  static hfrac_field_desc desc;
  static hfrac_step_limits limits;
  static hfrac_wall_state wall;
  static int32_t number;
  static int64_t big, other;
  static double real;
  static const void* data;
  static std::vector<unsigned char> image(1U << 22U);
  static int64_t image_size = 0;
  def = new_def();
  state.struct_size = sizeof state;
  setup.struct_size = sizeof setup;
  balance.struct_size = sizeof balance;
  solver.struct_size = sizeof solver;
  well.struct_size = sizeof well;
  desc.struct_size = sizeof desc;
  limits.struct_size = sizeof limits;
  wall.struct_size = sizeof wall;
  return {
      {"hfrac_sim_definition", [](hfrac_sim* s) { return hfrac_sim_definition(s, &def); }},
      {"hfrac_step", [](hfrac_sim* s) { return hfrac_step(s, 0); }},
      {"hfrac_advance", [](hfrac_sim* s) { return hfrac_advance(s, 0.0, &real, &number); }},
      {"hfrac_advance_to",
       [](hfrac_sim* s) {
         hfrac_sim_get_state(s, &state);  // its own time: there is nothing to do
         return hfrac_advance_to(s, state.time, &real, &number);
       }},
      {"hfrac_set_stop", [](hfrac_sim* s) { return hfrac_set_stop(s, 0.42, 0); }},
      {"hfrac_set_progress", [](hfrac_sim* s) { return hfrac_set_progress(s, nullptr, nullptr, 0.0); }},
      {"hfrac_sim_get_state", [](hfrac_sim* s) { return hfrac_sim_get_state(s, &state); }},
      {"hfrac_sim_get_setup", [](hfrac_sim* s) { return hfrac_sim_get_setup(s, &setup); }},
      {"hfrac_get_balance", [](hfrac_sim* s) { return hfrac_get_balance(s, &balance); }},
      {"hfrac_sim_get_solver", [](hfrac_sim* s) { return hfrac_sim_get_solver(s, &solver); }},
      {"hfrac_state_hash", [](hfrac_sim* s) { return hfrac_state_hash(s, &big); }},
      {"hfrac_well_count", [](hfrac_sim* s) { return hfrac_well_count(s, &number); }},
      {"hfrac_well_get", [](hfrac_sim* s) { return hfrac_well_get(s, 0, &well); }},
      {"hfrac_well_set_pressure", [](hfrac_sim* s) { return hfrac_well_set_pressure(s, 0, 30e6); }},
      {"hfrac_well_set_ramp", [](hfrac_sim* s) { return hfrac_well_set_ramp(s, 0, 30e6, 1e6); }},
      {"hfrac_well_set_rate", [](hfrac_sim* s) { return hfrac_well_set_rate(s, 0, 0.0); }},
      {"hfrac_field_info", [](hfrac_sim* s) { return hfrac_field_info(s, 0, &desc); }},
      {"hfrac_field_copy_f64",
       [](hfrac_sim* s) { return hfrac_field_copy_f64(s, HFRAC_DISC_RADIUS, nullptr, 0, &big); }},
      {"hfrac_field_copy_i32",
       [](hfrac_sim* s) { return hfrac_field_copy_i32(s, HFRAC_BOND_STATE, nullptr, 0, &big); }},
      {"hfrac_field_view",
       [](hfrac_sim* s) { return hfrac_field_view(s, HFRAC_DISC_RADIUS, &data, &big, &other); }},
      {"hfrac_epoch", [](hfrac_sim* s) { return hfrac_epoch(s, &big); }},
      {"hfrac_cracks_since",
       [](hfrac_sim* s) { return hfrac_cracks_since(s, 0, sizeof(hfrac_crack), nullptr, 0, &big, &other); }},
      {"hfrac_fractures",
       [](hfrac_sim* s) { return hfrac_fractures(s, sizeof(hfrac_fracture), nullptr, 0, &big); }},
      {"hfrac_fracture_line",
       [](hfrac_sim* s) {
         return hfrac_fracture_line(s, 0, sizeof(hfrac_fracture_point), nullptr, 0, &big);
       }},
      {"hfrac_state_size", [](hfrac_sim* s) { return hfrac_state_size(s, &big); }},
      {"hfrac_state_save",
       [](hfrac_sim* s) {
         return hfrac_state_save(s, image.data(), static_cast<int64_t>(image.size()), &image_size);
       }},
      {"hfrac_state_restore", [](hfrac_sim* s) { return hfrac_state_restore(s, image.data(), image_size); }},
      {"hfrac_step_prepare", [](hfrac_sim* s) { return hfrac_step_prepare(s); }},
      {"hfrac_step_do", [](hfrac_sim* s) { return hfrac_step_do(s, 1.0); }},
      {"hfrac_step_more", [](hfrac_sim* s) { return hfrac_step_more(s, 1.0); }},
      {"hfrac_step_finalize", [](hfrac_sim* s) { return hfrac_step_finalize(s); }},
      {"hfrac_step_prepare", [](hfrac_sim* s) { return hfrac_step_prepare(s); }},
      {"hfrac_step_reject", [](hfrac_sim* s) { return hfrac_step_reject(s); }},
      {"hfrac_set_on_step", [](hfrac_sim* s) { return hfrac_set_on_step(s, nullptr, nullptr); }},
      {"hfrac_set_log", [](hfrac_sim* s) { return hfrac_set_log(s, nullptr, nullptr, 0); }},
      {"hfrac_get_step_limits", [](hfrac_sim* s) { return hfrac_get_step_limits(s, &limits); }},
      {"hfrac_wall_count", [](hfrac_sim* s) { return hfrac_wall_count(s, &number); }},
      {"hfrac_wall_get",
       [](hfrac_sim* s) {
         // good on a simulation with walls only; without, it asks for the number that there is
         const int32_t status = hfrac_wall_get(s, 0, &wall);
         return status == HFRAC_ERR_ARGUMENT ? HFRAC_OK : status;
       }},
      {"hfrac_state_save_file",
       [](hfrac_sim* s) { return hfrac_state_save_file(s, "hfrac_misuse_test.state"); }},
      {"hfrac_state_load_file",
       [](hfrac_sim* s) {
         const int32_t status = hfrac_state_load_file(s, "hfrac_misuse_test.state");
         ::unlink("hfrac_misuse_test.state");
         return status;
       }},
      {"hfrac_set_formation_pressure", [](hfrac_sim* s) { return hfrac_set_formation_pressure(s, 25e6); }},
      {"hfrac_set_far_field", [](hfrac_sim* s) { return hfrac_set_far_field(s, 30e6, 30e6); }},
  };
}

TEST(Misuse, TheCallsAreGoodOnAGoodSimulation) {
  const Sim sim(quiet_def());
  for (const auto& call : all_calls())
    EXPECT_EQ(call.run(sim), HFRAC_OK) << call.name << ": " << last_error(sim);
}

TEST(Misuse, NullIsNoSimulation) {
  for (const auto& call : all_calls()) {
    EXPECT_EQ(call.run(nullptr), HFRAC_ERR_BAD_HANDLE) << call.name;
    EXPECT_EQ(last_error(), "sim is NULL; create it with hfrac_sim_create.") << call.name;
  }
}

TEST(Misuse, ForeignMemoryIsNoSimulation) {
  for (const int filling : {0x00, 0xEE, 0xFF}) {
    alignas(64) static unsigned char memory[16384];
    std::memset(memory, filling, sizeof memory);
    auto* const foreign = reinterpret_cast<hfrac_sim*>(memory);
    for (const auto& call : all_calls()) {
      EXPECT_EQ(call.run(foreign), HFRAC_ERR_BAD_HANDLE) << call.name;
      EXPECT_NE(last_error().find("not a living simulation"), std::string::npos) << call.name;
    }
    hfrac_sim* doomed = foreign;
    EXPECT_EQ(hfrac_sim_destroy(&doomed), HFRAC_ERR_BAD_HANDLE);
    EXPECT_EQ(doomed, foreign);
    char text[8];
    EXPECT_EQ(hfrac_last_error(foreign, text, sizeof text, nullptr), HFRAC_ERR_BAD_HANDLE);
    for (const unsigned char byte : memory) ASSERT_EQ(byte, filling);
  }
}

TEST(Misuse, NullResultsAreRefused) {
  const Sim sim(quiet_def());
  const int64_t hash = hash_of(sim);
  int64_t count = 0;
  int32_t number = 0;
  double real = 0.0;
  const void* data = nullptr;
  const struct {
    int32_t status;
    const char* name;
  } refused[] = {
      {hfrac_sim_definition(sim, nullptr), "hfrac_sim_definition"},
      {hfrac_sim_get_state(sim, nullptr), "hfrac_sim_get_state"},
      {hfrac_sim_get_setup(sim, nullptr), "hfrac_sim_get_setup"},
      {hfrac_get_balance(sim, nullptr), "hfrac_get_balance"},
      {hfrac_sim_get_solver(sim, nullptr), "hfrac_sim_get_solver"},
      {hfrac_state_hash(sim, nullptr), "hfrac_state_hash"},
      {hfrac_well_count(sim, nullptr), "hfrac_well_count"},
      {hfrac_well_get(sim, 0, nullptr), "hfrac_well_get"},
      {hfrac_advance(sim, 1.0, nullptr, &number), "hfrac_advance"},
      {hfrac_advance(sim, 1.0, &real, nullptr), "hfrac_advance"},
      {hfrac_field_info(sim, 0, nullptr), "hfrac_field_info"},
      {hfrac_field_find(nullptr, &number), "hfrac_field_find"},
      {hfrac_field_find("disc.radius", nullptr), "hfrac_field_find"},
      {hfrac_field_copy_f64(sim, HFRAC_DISC_RADIUS, nullptr, 0, nullptr), "hfrac_field_copy_f64"},
      {hfrac_field_copy_i32(sim, HFRAC_BOND_STATE, nullptr, 0, nullptr), "hfrac_field_copy_i32"},
      {hfrac_field_view(sim, HFRAC_DISC_RADIUS, nullptr, &count, &count), "hfrac_field_view"},
      {hfrac_field_view(sim, HFRAC_DISC_RADIUS, &data, nullptr, &count), "hfrac_field_view"},
      {hfrac_epoch(sim, nullptr), "hfrac_epoch"},
      {hfrac_cracks_since(sim, 0, sizeof(hfrac_crack), nullptr, 0, nullptr, &count), "hfrac_cracks_since"},
      {hfrac_fractures(sim, sizeof(hfrac_fracture), nullptr, 0, nullptr), "hfrac_fractures"},
      {hfrac_state_size(sim, nullptr), "hfrac_state_size"},
      {hfrac_state_save(sim, nullptr, 1 << 22, &count), "hfrac_state_save"},
      {hfrac_state_save(sim, &real, 8, nullptr), "hfrac_state_save"},
      {hfrac_state_restore(sim, nullptr, 8), "hfrac_state_restore"},
      {hfrac_state_save_file(sim, nullptr), "hfrac_state_save_file"},
      {hfrac_state_load_file(sim, nullptr), "hfrac_state_load_file"},
      {hfrac_get_step_limits(sim, nullptr), "hfrac_get_step_limits"},
      {hfrac_wall_count(sim, nullptr), "hfrac_wall_count"},
      {hfrac_last_error(sim, nullptr, 8, nullptr), "hfrac_last_error"},
      {hfrac_last_error(sim, nullptr, 0, nullptr), "hfrac_last_error"},
  };
  for (const auto& call : refused) EXPECT_EQ(call.status, HFRAC_ERR_ARGUMENT) << call.name;
  EXPECT_EQ(hash_of(sim), hash);
  for (const auto& call : all_calls()) EXPECT_EQ(call.run(sim), HFRAC_OK) << call.name;
}

TEST(Misuse, StructsNeverSizedAreRefused) {
  const Sim sim(quiet_def());
  for (const int filling : {0x00, 0xEE, 0xFF}) {
    std::vector<unsigned char> memory(sizeof(hfrac_sim_def), static_cast<unsigned char>(filling));
    void* const any = memory.data();
    EXPECT_EQ(hfrac_sim_definition(sim, static_cast<hfrac_sim_def*>(any)), HFRAC_ERR_STRUCT_SIZE);
    EXPECT_EQ(hfrac_sim_get_state(sim, static_cast<hfrac_sim_state*>(any)), HFRAC_ERR_STRUCT_SIZE);
    EXPECT_EQ(hfrac_sim_get_setup(sim, static_cast<hfrac_setup_report*>(any)), HFRAC_ERR_STRUCT_SIZE);
    EXPECT_EQ(hfrac_get_balance(sim, static_cast<hfrac_balance*>(any)), HFRAC_ERR_STRUCT_SIZE);
    EXPECT_EQ(hfrac_sim_get_solver(sim, static_cast<hfrac_solver_report*>(any)), HFRAC_ERR_STRUCT_SIZE);
    EXPECT_EQ(hfrac_well_get(sim, 0, static_cast<hfrac_well_state*>(any)), HFRAC_ERR_STRUCT_SIZE);
    EXPECT_EQ(hfrac_field_info(sim, 0, static_cast<hfrac_field_desc*>(any)), HFRAC_ERR_STRUCT_SIZE);
    hfrac_sim* none = nullptr;
    EXPECT_EQ(hfrac_sim_create(static_cast<hfrac_sim_def*>(any), &none), HFRAC_ERR_STRUCT_SIZE);
    EXPECT_NE(last_error().find("struct_size"), std::string::npos);
    EXPECT_TRUE(std::all_of(memory.begin(), memory.end(), [&](unsigned char b) { return b == filling; }));
  }
}

// The step that it interrupts is undone; the steps before it, and the one an on_step callback is told of, stand.
TEST(Misuse, WhatACallbackThrowsLosesNoWholeStep) {
  const Sim sim(cracking_def()), twin(cracking_def());
  ASSERT_GE(hfrac_step(sim, 1), 0);
  ASSERT_GE(hfrac_step(twin, 1), 0);
  int calls = 0;
  Host host([&](double, const char*) -> int32_t {
    if (++calls == 3) throw std::runtime_error("thrown by the host");
    return 0;
  });
  host.attach(sim);
  EXPECT_EQ(hfrac_step(sim, 1), HFRAC_ERR_CALLBACK);
  EXPECT_EQ(last_error(sim), "a callback threw: thrown by the host");
  EXPECT_EQ(hash_of(sim), hash_of(twin));
  ASSERT_EQ(hfrac_set_progress(sim, nullptr, nullptr, 0.0), HFRAC_OK);
  ASSERT_EQ(hfrac_set_on_step(
                sim, [](void*, hfrac_sim*, int64_t, double) -> int32_t { throw 7; }, nullptr),
            HFRAC_OK);
  EXPECT_EQ(hfrac_step(sim, 2), HFRAC_ERR_CALLBACK);
  ASSERT_GE(hfrac_step(twin, 1), 0);
  EXPECT_EQ(hash_of(sim), hash_of(twin));
  ASSERT_EQ(hfrac_set_on_step(sim, nullptr, nullptr), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  ASSERT_GE(hfrac_step(twin, 1), 0);
  EXPECT_EQ(hash_of(sim), hash_of(twin));
}

TEST(Misuse, AnExceptionWhileBuildingLeavesNothing) {
  hfrac::Definition def = quiet_def(20000);
  Host host([](double, const char*) -> int32_t { throw std::runtime_error("thrown by the host"); });
  def.progress = host.call;
  def.progress_user = &host;
  hfrac_sim* sim = nullptr;
  EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_ERR_CALLBACK);
  EXPECT_EQ(sim, nullptr);
  EXPECT_EQ(last_error(), "a callback threw: thrown by the host");
}

}  // namespace misuse_test
