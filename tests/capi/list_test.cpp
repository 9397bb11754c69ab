// SPDX-License-Identifier: BSD-3-Clause
// The lists of a definition: of the caller's or the library's, items of any size, any number of them.
#include <gtest/gtest.h>

#include <cstring>
#include <utility>
#include <vector>

#include "../joint_def.hpp"
#include "sim_support.hpp"
#include "support.hpp"

namespace list_test {

using namespace testing_capi;

constexpr hfrac_joint_def joint_at(double y) {
  return joint_def(20.0, y, 80.0, y, 0.5, 0.25, 0.125, HFRAC_JOINT_BONDED);
}

hfrac_well_def well_at(double x, double y, double radius, double pressure) {
  hfrac_well_def well{};
  well.x = x;
  well.y = y;
  well.radius = radius;
  well.pressure = pressure;
  return well;
}

template <class Item>
void give(hfrac_sim_def& def, Item*& list, int64_t& count, int64_t& size, std::vector<Item>& items) {
  (void)def;
  list = items.data();
  count = static_cast<int64_t>(items.size());
  size = sizeof(Item);
}

TEST(Lists, OfTheCallerAreReadAndNeverWritten) {
  std::vector<hfrac_joint_def> joints = {joint_at(30.0), joint_at(40.0)};
  const auto before = joints;
  hfrac::Definition def = sound_def();
  give(def, def.joints, def.joint_count, def.joint_size, joints);
  ASSERT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
  double value = 0.0;
  ASSERT_EQ(hfrac_sim_def_get_f64(&def, "joint[1].y1", &value), HFRAC_OK);
  EXPECT_EQ(value, 40.0);
  EXPECT_EQ(def.joints, joints.data());
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "joint[1].y1", 45.0), HFRAC_OK);
  EXPECT_NE(def.joints, joints.data()) << "a list that a key changes becomes the library's";
  EXPECT_EQ(def.joints[1].y1, 45.0);
  EXPECT_EQ(def.joints[0].shear_factor, 0.25);
  EXPECT_EQ(std::memcmp(joints.data(), before.data(), sizeof(hfrac_joint_def) * 2), 0);
  ASSERT_EQ(hfrac_sim_def_free(&def), HFRAC_OK);
  EXPECT_EQ(def.joints, nullptr);
  EXPECT_EQ(def.joint_count, 0);
  EXPECT_EQ(def.stress_sigma_hmin, 30e6);
  EXPECT_EQ(hfrac_sim_def_free(nullptr), HFRAC_OK);
}

TEST(Lists, SmallerItemsTakeDefaultsForWhatTheyLack) {
  struct Older {
    double x1, y1, x2, y2, tensile_factor;
  } items[] = {{20.0, 30.0, 80.0, 30.0, 0.5}, {20.0, 40.0, 80.0, 40.0, 0.25}};
  hfrac::Definition def = sound_def();
  def.joints = reinterpret_cast<hfrac_joint_def*>(items);
  def.joint_count = 2;
  def.joint_size = sizeof(Older);
  ASSERT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
  double value = 0.0;
  ASSERT_EQ(hfrac_sim_def_get_f64(&def, "joint[1].tensile_factor", &value), HFRAC_OK);
  EXPECT_EQ(value, 0.25);
  ASSERT_EQ(hfrac_sim_def_get_f64(&def, "joint[1].shear_factor", &value), HFRAC_OK);
  EXPECT_EQ(value, 1.0);
  ASSERT_EQ(hfrac_sim_def_get_f64(&def, "joint[1].friction", &value), HFRAC_OK);
  EXPECT_EQ(value, -1.0);
  // What the library makes of them keeps their size, so that the host can read them by its own struct.
  ASSERT_EQ(hfrac_sim_def_set_i64(&def, "joint_count", 3), HFRAC_OK);
  EXPECT_EQ(def.joint_size, static_cast<int64_t>(sizeof(Older)));
  const auto* read = reinterpret_cast<const Older*>(def.joints);
  EXPECT_EQ(read[1].y2, 40.0);
  EXPECT_EQ(read[2].tensile_factor, 1.0);
}

TEST(Lists, LargerItemsMustHaveAnEmptyTail) {
  struct Newer {
    hfrac_joint_def joint;
    double more;
  } items[] = {{joint_at(30.0), 0.0}, {joint_at(40.0), 0.0}};
  hfrac::Definition def = sound_def();
  def.joints = &items[0].joint;
  def.joint_count = 2;
  def.joint_size = sizeof(Newer);
  ASSERT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
  double value = 0.0;
  ASSERT_EQ(hfrac_sim_def_get_f64(&def, "joint[1].y1", &value), HFRAC_OK);
  EXPECT_EQ(value, 40.0);
  items[1].more = 1.0;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_NE(last_error().find(": joint[1] was made with a newer header"), std::string::npos) << last_error();
  for (const int64_t size : {0, 4, 12, -64, 65544}) {
    def.joint_size = size;
    EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_STRUCT_SIZE) << size;
    EXPECT_NE(last_error().find("sizeof(hfrac_joint_def)"), std::string::npos) << last_error();
  }
}

TEST(Lists, CopiesHaveListsOfTheirOwn) {
  const TemporaryFolder folder;
  hfrac::Definition def = sound_def();
  std::vector<hfrac_joint_def> joints = {joint_at(30.0)};
  give(def, def.joints, def.joint_count, def.joint_size, joints);
  hfrac::Definition copy = def;
  EXPECT_NE(copy.wells, def.wells);
  EXPECT_NE(copy.joints, def.joints);
  EXPECT_EQ(written(copy), written(def));
  copy.wells[0].radius = 7.0;
  EXPECT_EQ(def.wells[0].radius, 6.0);
  ASSERT_EQ(hfrac_sim_def_copy(&def, &def), HFRAC_OK) << "onto itself";
  EXPECT_NE(def.joints, joints.data());
  hfrac::Definition moved = std::move(copy);
  EXPECT_EQ(moved.wells[0].radius, 7.0);
  // A file that is refused leaves the lists as they are.
  const hfrac_sim_def bytes = def;
  EXPECT_EQ(hfrac_sim_def_load(&def, folder.write("[[well]]\nradius = \"wide\"\n").c_str()),
            HFRAC_ERR_CASE_FILE);
  EXPECT_EQ(std::memcmp(&def, &bytes, sizeof bytes), 0);
  hfrac_sim_def never;
  std::memset(&never, 0, sizeof never);
  EXPECT_EQ(hfrac_sim_def_copy(&def, &never), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_EQ(hfrac_sim_def_copy(&never, &def), HFRAC_ERR_STRUCT_SIZE);
}

TEST(Lists, ThousandsOfItemsGoThroughAFile) {
  const TemporaryFolder folder;
  hfrac::Definition def = sound_def();
  def.packing_disc_count = 200000;
  std::vector<hfrac_well_def> wells;
  std::vector<hfrac_joint_def> joints;
  std::vector<hfrac_schedule_def> schedule;
  for (int k = 0; k < 1000; ++k) {
    wells.push_back(well_at(4.0 + 2.9 * (k % 32), 4.0 + 2.9 * (k / 32), 0.5, 45e6));
    joints.push_back(joint_at(0.09 * (k + 1)));
  }
  for (int k = 0; k < 10000; ++k)
    schedule.push_back({k % 1000, 1.0 + k / 1000, 40e6, HFRAC_WELL_PRESSURE, 0});
  give(def, def.wells, def.well_count, def.well_size, wells);
  give(def, def.joints, def.joint_count, def.joint_size, joints);
  give(def, def.schedule, def.schedule_count, def.schedule_size, schedule);
  ASSERT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
  hfrac::Definition read;
  ASSERT_EQ(hfrac_sim_def_load(&read, folder.write(written(def)).c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(read.well_count, 1000);
  EXPECT_EQ(read.joint_count, 1000);
  ASSERT_EQ(read.schedule_count, 10000);
  EXPECT_EQ(written(read), written(def));
  EXPECT_EQ(std::memcmp(read.wells, wells.data(), 1000 * sizeof wells[0]), 0);
  EXPECT_EQ(std::memcmp(read.joints, joints.data(), 1000 * sizeof joints[0]), 0);

  schedule[9999].time = 1.0;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_MODEL);
  EXPECT_EQ(last_error().rfind("schedule[9999].time = 1 s is not after", 0), 0u) << last_error();
  schedule[9999] = {1000, 11.0, 40e6, HFRAC_WELL_PRESSURE, 0};
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_MODEL);
  EXPECT_EQ(last_error().rfind("schedule[9999].well = 1000 is not there: the case has 1000 wells", 0), 0u)
      << last_error();
  schedule[9999] = {999, 12.0, 40e6, HFRAC_WELL_PRESSURE, 0};
  wells[998].radius = -1.0;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error().rfind("well[998].radius = -1 ", 0), 0u) << last_error();
  wells[998] = wells[997];
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_MODEL);
  EXPECT_EQ(last_error().rfind("well[997] and well[998] overlap", 0), 0u) << last_error();
}

// More than any list held when they were arrays: 8 wells, 64 joints, 64 entries.
TEST(Lists, LongOnesAreBuiltDrivenAndRestored) {
  hfrac::Definition def = quiet_def(1500);
  std::vector<hfrac_well_def> wells;
  std::vector<hfrac_joint_def> joints;
  std::vector<hfrac_schedule_def> schedule;
  for (int k = 0; k < 12; ++k)
    wells.push_back(well_at(14.0 + 24.0 * (k % 4), 20.0 + 30.0 * (k / 4), 4.0, 26e6));
  for (int k = 0; k < 100; ++k)
    joints.push_back(joint_def(5.0, 0.9 * (k + 1), 95.0, 0.9 * (k + 1), 2.0, 2.0, -1.0, HFRAC_JOINT_BONDED));
  for (int k = 0; k < 120; ++k)
    schedule.push_back(
        {k % 12, 1.0 + k / 12, (k % 12 == 11 ? 27e6 : 26e6) + 1e3 * k, HFRAC_WELL_PRESSURE, 0});
  give(def, def.wells, def.well_count, def.well_size, wells);
  give(def, def.joints, def.joint_count, def.joint_size, joints);
  give(def, def.schedule, def.schedule_count, def.schedule_size, schedule);
  const Sim sim(def), twin(def);
  // Create copied them.
  wells.assign(12, {});
  schedule.clear();
  hfrac::Definition built;
  ASSERT_EQ(hfrac_sim_definition(sim, &built), HFRAC_OK) << last_error();
  ASSERT_EQ(built.well_count, 12);
  ASSERT_EQ(built.joint_count, 100);
  ASSERT_EQ(built.schedule_count, 120);
  EXPECT_EQ(built.wells[11].y, 80.0);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  int64_t size = 0;
  ASSERT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
  std::vector<unsigned char> image(static_cast<std::size_t>(size));
  ASSERT_EQ(hfrac_state_save(sim, image.data(), size, &size), HFRAC_OK);
  ASSERT_EQ(hfrac_state_restore(twin, image.data(), size), HFRAC_OK) << last_error(twin);
  for (const hfrac_sim* one : {static_cast<hfrac_sim*>(sim), static_cast<hfrac_sim*>(twin)})
    ASSERT_GE(hfrac_step(const_cast<hfrac_sim*>(one), 1), 0);
  EXPECT_EQ(hash_of(sim), hash_of(twin));
  hfrac_well_state well{};
  well.struct_size = sizeof well;
  ASSERT_EQ(hfrac_well_get(sim, 11, &well), HFRAC_OK);
  EXPECT_EQ(well.target_pressure, 27e6 + 1e3 * 11);
  ASSERT_EQ(hfrac_well_get(sim, 10, &well), HFRAC_OK);
  EXPECT_EQ(well.target_pressure, 26e6 + 1e3 * 10);
}

}  // namespace list_test
