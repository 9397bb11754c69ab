// SPDX-License-Identifier: BSD-3-Clause
// What libhfrac gives on a device is what it gives on the processor, to the last bit. The device is whatever libhfrac_gpu lies beside the
// library, over whatever driver: in CI the emulated one (emulated_driver.cpp), by tests/gpu/run a card's.
#include <gtest/gtest.h>

#include "emulated.hpp"
#include "golden.hpp"

namespace {

constexpr int64_t gpu = 1, automatic = 2;

class GoldenOnADevice : public testing::TestWithParam<golden::Case> {};

TEST_P(GoldenOnADevice, HasTheBitsOfTheProcessor) {
  golden::Case which = GetParam();
  const bool explicit_solver = which.def.solver_kind == 0;
  which.def.run_device = explicit_solver ? gpu : automatic;
  const auto numbers = golden::wanted(HFRAC_GOLDEN_FILE);
  ASSERT_TRUE(numbers.contains(which.name));
  EXPECT_EQ(golden::fingerprint(which, 1), numbers.at(which.name));
}

INSTANTIATE_TEST_SUITE_P(Cases, GoldenOnADevice, testing::ValuesIn(golden::cases()),
                         [](const auto& which) { return which.param.name; });

TEST(Device, SolvesForTheFlowStepsPressures) {
  if (emulated::launches("gradient_begin_pass") < 0) GTEST_SKIP() << "not the emulated driver";
  const auto launches_in = [](int64_t flow_solver) {
    hfrac::Definition def = golden::cases().front().def;
    def.flow_solver = flow_solver;
    def.run_device = gpu;
    hfrac_sim* sim = nullptr;
    EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK);
    const long before = emulated::launches("grid_visit_few") + emulated::launches("gradient_go_along");
    EXPECT_EQ(hfrac_step(sim, 1), HFRAC_OK);
    hfrac_sim_destroy(&sim);
    return emulated::launches("grid_visit_few") + emulated::launches("gradient_go_along") - before;
  };
  constexpr int64_t direct = 1, iterative = 2;
  EXPECT_EQ(launches_in(direct), 0);
  EXPECT_GT(launches_in(iterative), 0);
}

// A well's pore has more corners than one thread does, and with 2000 discs it lies across tiles.
TEST(Device, DoesPoresOfManyCornersByABlock) {
  hfrac::Definition def = golden::cases().front().def;
  def.packing_disc_count = 2000;
  hfrac_sim* sim = nullptr;
  ASSERT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK);
  EXPECT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  int64_t hash = 0, there = 1;
  EXPECT_EQ(hfrac_state_hash(sim, &hash), HFRAC_OK);
  hfrac_sim_destroy(&sim);
  def.run_device = gpu;
  ASSERT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK);
  const long before = emulated::launches("large_pores");
  EXPECT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  // A real driver counts nothing.
  if (before >= 0) {
    EXPECT_GT(emulated::launches("large_pores"), before);
  }
  EXPECT_EQ(hfrac_state_hash(sim, &there), HFRAC_OK);
  EXPECT_EQ(there, hash);
  hfrac_sim_destroy(&sim);
}

golden::Case small() {
  return golden::cases().front();
}

std::string create_and_fail(const hfrac::Definition& def, int32_t status) {
  hfrac_sim* sim = nullptr;
  EXPECT_EQ(hfrac_sim_create(&def, &sim), status);
  std::string text(1024, ' ');
  hfrac_last_error(nullptr, text.data(), static_cast<int32_t>(text.size()), nullptr);
  hfrac_sim_destroy(&sim);
  return text.substr(0, text.find('\0'));
}

TEST(Device, IsRefusedWhatItDoesNotRun) {
  const auto refused = [](const auto& change) {
    hfrac::Definition def = small().def;
    def.run_device = gpu;
    change(def);
    return create_and_fail(def, HFRAC_ERR_MODEL);
  };
  EXPECT_NE(refused([](auto& def) {
              def.solver_kind = 1;
            }).find("solver.kind = \"quasi-static\" runs on the processor alone"),
            std::string::npos);
  EXPECT_NE(refused([](auto& def) { def.fracture_law = 1; }).find("fracture.law"), std::string::npos);
  EXPECT_NE(refused([](auto& def) { def.boundary_kind = 2; }).find("boundary.kind"), std::string::npos);
}

TEST(Device, GoesOnFromAStateOfTheProcessorAndBack) {
  const auto hash_after = [](int64_t first, int64_t second) {
    std::string image;
    int64_t hash = 0;
    for (const int64_t device : {first, second}) {
      hfrac::Definition def = small().def;
      def.run_device = device;
      hfrac_sim* sim = nullptr;
      EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK);
      if (!image.empty()) {
        EXPECT_EQ(hfrac_state_restore(sim, image.data(), static_cast<int64_t>(image.size())), HFRAC_OK);
      }
      EXPECT_EQ(hfrac_step(sim, 1), HFRAC_OK);
      int64_t size = 0;
      EXPECT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
      image.resize(static_cast<std::size_t>(size));
      EXPECT_EQ(hfrac_state_save(sim, image.data(), size, &size), HFRAC_OK);
      EXPECT_EQ(hfrac_state_hash(sim, &hash), HFRAC_OK);
      hfrac_sim_destroy(&sim);
    }
    return hash;
  };
  const int64_t alone = hash_after(0, 0);
  EXPECT_EQ(hash_after(0, gpu), alone);
  EXPECT_EQ(hash_after(gpu, 0), alone);
  EXPECT_EQ(hash_after(gpu, gpu), alone);
}

TEST(Device, IsListed) {
  int32_t count = 0;
  std::string text(1024, ' ');
  ASSERT_EQ(hfrac_devices(&count, text.data(), static_cast<int32_t>(text.size()), nullptr), HFRAC_OK);
  EXPECT_GE(count, 1) << text;
}

}  // namespace
