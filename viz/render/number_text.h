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

// Names of columns and arrays as people read them. Every name of the project ends with its SI unit
// ("well_pressure_Pa"); a picture says "well pressure" and shows the values in a unit that keeps them short.

struct Quantity {
  std::string name;  // "well pressure"
  std::string unit;  // "MPa", empty for none
  double scale = 1;  // shown values are the SI ones times this

  std::string label() const { return unit.empty() ? name : name + " (" + unit + ")"; }
};

// `largest`: of the values' sizes, in SI; it decides between m and mm. "name (unit)" is taken as it stands.
Quantity quantity_of(const std::string& column, double largest);

// A single value: "45 MPa".
std::string quantity_text(const std::string& column, double value);

}  // namespace hfrac::viz
