// SPDX-License-Identifier: BSD-3-Clause
// State images of every format a released version wrote lie in tests/trust/images. Each loads and goes on, or is refused with a
// text that names its format and the way out.
//
// Before a release: HFRAC_WRITE_IMAGE=1 build/bin/hfrac_guards_tests --gtest_filter='OldImages.*' writes that of the format of
// today, format_N.image.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "../capi/sim_support.hpp"
#include "../joint_def.hpp"

namespace {

using namespace testing_capi;
namespace fs = std::filesystem;

// Given discs, so that no packing stands between the versions.
hfrac::Definition model(std::vector<double>& discs) {
  for (int j = 0; j < 11; ++j) {
    for (int i = 0; i < 9; ++i)
      discs.insert(discs.end(), {5.0 * (1 + 2 * i + j % 2), 5.0 * (1 + 1.7320508 * j), 5.0});
  }
  hfrac::Definition def = cracking_def();
  def.given_discs = discs.data();
  def.given_disc_count = static_cast<int64_t>(discs.size() / 3);
  def.wells[0].x = 50.0;
  def.wells[0].y = 48.0;
  def.wells[0].radius = 12.0;
  def.wells[0].pressure = 50e6;
  // A weak line beside the well, since the lattice breaks as a whole or not at all.
  hfrac_sim_def_set_i64(&def, "joint_count", 1);
  def.joints[0] = joint_def(62.0, 44.0, 73.0, 44.0, 0.2, 0.2, -1.0, HFRAC_JOINT_BONDED);
  return def;
}

TEST(OldImages, LoadOrAreRefusedByFormat) {
  const fs::path folder = HFRAC_IMAGE_FOLDER;
  std::vector<double> discs;
  const Sim sim(model(discs));
  ASSERT_GE(hfrac_step(sim, 2), 0) << last_error(sim);
  const int64_t step = state_of(sim).step;
  ASSERT_GT(state_of(sim).crack_count, 0);
  int64_t size = 0;
  ASSERT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
  std::vector<char> image(static_cast<std::size_t>(size));
  ASSERT_EQ(hfrac_state_save(sim, image.data(), size, &size), HFRAC_OK);
  std::uint32_t today = 0;
  std::memcpy(&today, image.data() + 8, 4);
  if (std::getenv("HFRAC_WRITE_IMAGE") != nullptr) {
    const auto file = folder / ("format_" + std::to_string(today) + ".image");
    ASSERT_EQ(hfrac_state_save_file(sim, file.c_str()), HFRAC_OK) << last_error(sim);
  }
  // What was saved today comes back, whether or not a release has written this format yet; and goes on as the original does.
  const fs::path saved = fs::path(testing::TempDir()) / "today.image";
  ASSERT_EQ(hfrac_state_save_file(sim, saved.c_str()), HFRAC_OK) << last_error(sim);
  const int64_t hash = hash_of(sim);
  ASSERT_GE(hfrac_step(sim, 2), 0) << last_error(sim);
  const int64_t later = hash_of(sim);
  ASSERT_NE(later, hash);
  ASSERT_EQ(hfrac_state_load_file(sim, saved.c_str()), HFRAC_OK) << last_error(sim);
  fs::remove(saved);
  EXPECT_EQ(hash_of(sim), hash);
  EXPECT_EQ(state_of(sim).step, step);
  ASSERT_GE(hfrac_step(sim, 2), 0) << last_error(sim);
  EXPECT_EQ(hash_of(sim), later);

  int released = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".image") continue;
    ++released;
    std::uint32_t format = 0;
    std::ifstream stream(entry.path(), std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
    ASSERT_GT(bytes.size(), 40U);
    std::memcpy(&format, bytes.data() + 8, 4);
    const int32_t status = hfrac_state_load_file(sim, entry.path().c_str());
    if (format == today) {
      ASSERT_EQ(status, HFRAC_OK) << "an image of today's format must load: " << last_error(sim);
      EXPECT_EQ(hash_of(sim), hash) << entry.path();
      EXPECT_GE(hfrac_step(sim, 2), 0) << last_error(sim);
      EXPECT_EQ(hash_of(sim), later) << entry.path();
    } else {
      ASSERT_EQ(status, HFRAC_ERR_FILE);
      EXPECT_NE(last_error(sim).find("format is " + std::to_string(format)), std::string::npos)
          << last_error(sim);
      EXPECT_NE(last_error(sim).find("use the version"), std::string::npos) << last_error(sim);
      EXPECT_EQ(hash_of(sim), later) << "a refused image changed the simulation";
    }
  }
  EXPECT_GE(released, 1);
}

}  // namespace
