// SPDX-License-Identifier: BSD-3-Clause
// The results that stand in golden.txt come out again, on any number of workers.
//
// They hold for x86-64 with glibc; elsewhere three functions of the C library (atan2, cbrt, hypot) may round otherwise, and
// only the equality among workers is demanded.
#include <gtest/gtest.h>

#include "golden.hpp"

namespace {

class Golden : public testing::TestWithParam<golden::Case> {};

TEST_P(Golden, SameBitsOnAnyNumberOfWorkers) {
  const auto& which = GetParam();
  const std::uint64_t alone = golden::fingerprint(which, 1);
#if defined(__x86_64__) && defined(__GLIBC__)
  const auto numbers = golden::wanted(HFRAC_GOLDEN_FILE);
  ASSERT_TRUE(numbers.contains(which.name)) << "golden.txt has no " << which.name;
  EXPECT_EQ(alone, numbers.at(which.name)) << which.name
                                           << " gives another result than golden.txt says. If that is meant, "
                                              "say so in the change and write the file "
                                           << "anew: build/bin/hfrac_golden > tests/trust/golden.txt";
#endif
  for (const int64_t workers : {2, 3, 8})
    EXPECT_EQ(golden::fingerprint(which, workers), alone) << workers << " workers";
}

INSTANTIATE_TEST_SUITE_P(Cases, Golden, testing::ValuesIn(golden::cases()),
                         [](const auto& which) { return which.param.name; });

}  // namespace
