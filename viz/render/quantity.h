// SPDX-License-Identifier: BSD-3-Clause
// Names of columns and arrays as people read them. Every name of the project ends with its SI unit
// ("well_pressure_Pa"); a picture says "well pressure" and shows the values in a unit that keeps them short.
#pragma once

#include <string>

namespace hfrac::viz {

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
