// SPDX-License-Identifier: BSD-3-Clause
// Sums without rounding: any order and any split give the same bits, and those are the true sum's, rounded once.
#include "core/exact_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace exact_sum_test {

using hfrac::ExactSum;

double sum_of(const std::vector<double>& values) {
  ExactSum sum;
  for (const double v : values) sum.add(v);
  return sum.value();
}

std::vector<double> numbers(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  std::vector<double> values;
  while (values.size() < count) {
    const double v = std::bit_cast<double>(random());
    if (std::isfinite(v) && std::abs(v) < 1e300) values.push_back(v);
  }
  return values;
}

TEST(ExactSum, IsTheNumberItselfForOneNumber) {
  for (const double v : numbers(1, 10000)) {
    EXPECT_EQ(sum_of({v}), v);
    EXPECT_EQ(sum_of({v, v, -v}), v);
  }
  for (const double v : {0.0, 5e-324, -5e-324, 2.2250738585072014e-308, 1.0, -1.0,
                         std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()})
    EXPECT_EQ(sum_of({v}), v);
}

// Two numbers add up in hardware with one rounding, too.
TEST(ExactSum, RoundsOnceToNearest) {
  const auto values = numbers(2, 20000);
  std::mt19937_64 random(3);
  for (std::size_t k = 0; k + 1 < values.size(); ++k) {
    const double a = values[k];
    const double b = std::ldexp(values[k + 1] / std::exp2(std::ilogb(values[k + 1])),
                                std::ilogb(a) + static_cast<int>(random() % 120) - 60);
    const double plain = a + b;
    if (std::abs(plain) < 1e-290 || !std::isfinite(plain)) continue;
    ASSERT_EQ(sum_of({a, b}), plain) << a << " " << b;
  }
  // Halfway goes to even, and what is lost below decides.
  const double ulp = std::exp2(-52);
  EXPECT_EQ(sum_of({1.0, 0.5 * ulp}), 1.0);
  EXPECT_EQ(sum_of({1.0, 0.5 * ulp, std::exp2(-900)}), 1.0 + ulp);
  EXPECT_EQ(sum_of({1.0 + ulp, 0.5 * ulp, -std::exp2(-900)}), 1.0 + ulp);
  EXPECT_EQ(sum_of({1e300, 1.0, -1e300}), 1.0);
}

TEST(ExactSum, DoesNotDependOnOrderOrSplit) {
  auto values = numbers(4, 5000);
  const double once = sum_of(values);
  std::mt19937_64 random(5);
  for (int round = 0; round < 20; ++round) {
    std::shuffle(values.begin(), values.end(), random);
    EXPECT_EQ(sum_of(values), once);
    // As ranks do: each its part, then the integers.
    ExactSum whole;
    for (std::size_t part = 0; part < 7; ++part) {
      ExactSum some;
      for (std::size_t k = part; k < values.size(); k += 7) some.add(values[k]);
      some.carry();
      for (std::size_t w = 0; w < ExactSum::word_count; ++w) whole.words()[w] += some.words()[w];
    }
    EXPECT_EQ(whole.value(), once);
  }
}

TEST(ExactSum, SaysWhatIsNoNumber) {
  EXPECT_TRUE(std::isnan(sum_of({1.0, std::numeric_limits<double>::infinity()})));
  EXPECT_TRUE(std::isnan(sum_of({1.0, std::numeric_limits<double>::quiet_NaN()})));
}

}  // namespace exact_sum_test
