// SPDX-License-Identifier: BSD-3-Clause
// What libhfrac gives on a device is what it gives on the processor, to the last bit. The device is whatever libhfrac_gpu lies beside the
// library: in CI the emulated one (emulated_device.cpp), by tests/gpu/run a card's.
#include <gtest/gtest.h>

#include <cinttypes>
#include <fstream>
#include <map>

#include "golden.hpp"

namespace {

constexpr int64_t gpu = 1, automatic = 2;

std::map<std::string, std::uint64_t> wanted() {
  std::map<std::string, std::uint64_t> numbers;
  std::ifstream file(HFRAC_GOLDEN_FILE);
  std::string name, number;
  while (file >> name >> number) numbers[name] = std::stoull(number, nullptr, 16);
  return numbers;
}

class GoldenOnADevice : public testing::TestWithParam<golden::Case> {};

TEST_P(GoldenOnADevice, HasTheBitsOfTheProcessor) {
  golden::Case which = GetParam();
  const bool explicit_solver = which.def.solver_kind == 0;
  which.def.run_device = explicit_solver ? gpu : automatic;
  const auto numbers = wanted();
  ASSERT_TRUE(numbers.contains(which.name));
  EXPECT_EQ(golden::fingerprint(which, 1), numbers.at(which.name));
}

INSTANTIATE_TEST_SUITE_P(Cases, GoldenOnADevice, testing::ValuesIn(golden::cases()),
                         [](const auto& which) { return which.param.name; });

}  // namespace
