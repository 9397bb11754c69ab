// SPDX-License-Identifier: BSD-3-Clause
// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hfrac::viz {

inline constexpr double pascal_per_megapascal = 1e6;
inline constexpr double millimetres_per_metre = 1e3;

// "0.35 ms", "12.5 s", "4.2 min", "3.1 h", "2.4 d"
std::string time_text(double seconds);
// Thousands apart by a thin space: "12 345"
std::string count_text(std::int64_t count);
// With three figures that count, no trailing zeros: "45", "0.125", "1.2e-05"
std::string value_text(double value);
// "1 crack", "27 cracks"
std::string counted(std::int64_t count, const std::string& singular);

// Round values inside [lowest, highest], about `wanted` of them, with texts of equal number of decimals.
struct Tick {
  double value = 0;
  std::string text;
};
std::vector<Tick> round_ticks(double lowest, double highest, int wanted);

// The largest of 1, 2, 5 times a power of ten that is not above `limit`.
double round_length(double limit);

}  // namespace hfrac::viz
