// SPDX-License-Identifier: BSD-3-Clause
// Whatever an option is set to, ranks give the bits of one, or refuse it with the same words. All its choices, and of numbers half and twice
// the default, are tried, each in one of three models: rock between walls, a fracture of facets, a joint under far-field stress.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "sim_support.hpp"
#include "thread_exchange.hpp"

namespace ranks_options_test {

using namespace testing_capi;

constexpr int models = 3;

hfrac::Definition model(int which) {
  hfrac::Definition def = cracking_def(1600);  // three tiles and more: each rank has discs of its own
  def.packing_brick_discs = 200;
  def.packing_residual = 1e-2;
  def.stepping_max_cycles = 2000;
  def.stepping_flow_step = 1e-2;
  def.wells[0].pressure = 70e6;
  if (which == 0) return def;
  def.stress_convention = 0;
  def.boundary_kind = 0;
  def.stress_sigma_Hmax = 12e6;
  def.stress_sigma_hmin = 10e6;
  def.fluid_formation_pressure = 0.0;
  if (which == 1) {
    def.solver_kind = 1;
    def.stepping_mode = 2;
    def.stepping_flow_step = 1e-4;  // a few increments
    def.bond_fracture_toughness = 2e6;
    def.fracture_plane_modulus = 18.6e9;
    return def;
  }
  def.wells[0].pressure = 30e6;
  EXPECT_EQ(hfrac_sim_def_set_i64(&def, "joint_count", 1), HFRAC_OK);
  auto& joint = def.joints[0];
  joint.x1 = 20.0;
  joint.y1 = 20.0;
  joint.x2 = 80.0;
  joint.y2 = 75.0;
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "joint[0].state", "smooth-broken"), HFRAC_OK);
  return def;
}

std::set<double> values_of(const hfrac_option_info& info) {
  const double there = info.default_value;
  std::set<double> values{std::max(info.minimum, 0.5 * there),
                          std::min(info.maximum, there == 0.0 ? 1.0 : 2.0 * there)};
  if (info.type == 2) values.clear();
  for (double choice = info.minimum; info.type == 2 && choice <= info.maximum; ++choice)
    values.insert(choice);
  std::set<double> found;
  for (const double value : values) found.insert(info.type == 0 ? value : std::round(value));
  found.erase(there);
  return found;
}

struct End {
  int32_t created = 0, stepped = 0;
  std::uint64_t hash = 0;
  std::string text;
};

template <class Create>
End end_of(const Create& create) {
  hfrac_sim* sim = nullptr;
  End end;
  end.created = create(&sim);
  if (end.created != HFRAC_OK) {
    end.text = last_error();
    return end;
  }
  end.stepped = hfrac_step(sim, 1);
  if (end.stepped < 0) end.text = last_error(sim);
  end.hash = hash_of(sim);
  hfrac_sim_destroy(&sim);
  return end;
}

void compare(const hfrac::Definition& alone, const std::string& what) {
  const End one = end_of([&](hfrac_sim** sim) { return hfrac_sim_create(&alone, sim); });
  hfrac::Definition shared = alone;
  shared.run_workers =
      alone.solver_kind == 1 ? 1 : 2;  // its factor has the ranks wait for each other often enough
  Meeting meeting(3);
  meeting.run([&](int32_t rank) {
    const auto exchange = meeting.exchange(rank);
    const End end = end_of([&](hfrac_sim** sim) { return hfrac_sim_create_on(&shared, &exchange, sim); });
    EXPECT_EQ(end.created, one.created) << what;
    EXPECT_EQ(end.stepped, one.stepped) << what;
    EXPECT_EQ(end.text, one.text) << what;
    EXPECT_EQ(end.hash, one.hash) << what;
  });
}

class RanksOptionSlow : public testing::TestWithParam<int32_t> {};

// What the models are without any option set: no refusal that all share, on ranks that each have discs.
TEST(RanksOptionModels, StandAndStep) {
  for (int which = 0; which < models; ++which) {
    const hfrac::Definition def = model(which);
    const End one = end_of([&](hfrac_sim** sim) { return hfrac_sim_create(&def, sim); });
    EXPECT_EQ(one.created, HFRAC_OK) << which << ": " << one.text;
    EXPECT_GE(one.stepped, 0) << which << ": " << one.text;
    compare(def, "model " + std::to_string(which));
  }
}

TEST_P(RanksOptionSlow, GivesTheBitsOfOne) {
  const auto info = read_struct<hfrac_option_info>([&](auto* to) { return hfrac_option_at(GetParam(), to); });
  // Other sizes take long, workers are two, and a card is refused for a reason of the ranks' own.
  for (const char* key : {"packing.disc_count", "run.workers", "run.device"})
    if (std::string(info.key) == key) return;
  int which = GetParam();
  for (const double value : values_of(info)) {
    hfrac::Definition def = model(which++ % models);
    const int32_t set = info.type == 0 ? hfrac_sim_def_set_f64(&def, info.key, value)
                                       : hfrac_sim_def_set_i64(&def, info.key, static_cast<int64_t>(value));
    ASSERT_EQ(set, HFRAC_OK) << last_error();
    compare(def, std::string(info.key) + " = " + std::to_string(value));
  }
}

int32_t option_count() {
  int32_t count = 0;
  hfrac_option_count(&count);
  return count;
}

INSTANTIATE_TEST_SUITE_P(All, RanksOptionSlow, testing::Range(0, option_count()), [](const auto& at) {
  const auto option = read_struct<hfrac_option_info>([&](auto* to) { return hfrac_option_at(at.param, to); });
  std::string name = option.key;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

}  // namespace ranks_options_test
