// SPDX-License-Identifier: BSD-3-Clause
#include "heat/micro_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "options/choices.hpp"
#include "options/number_text.hpp"

namespace hfrac {

MicroTable::MicroTable(const Options& o) {
  if (ThermalMode{o.thermal_mode} == ThermalMode::off ||
      ThermalParameters{o.thermal_parameters} == ThermalParameters::constant)
    return;
  rows_ = {{o.thermal_temperature_1, {o.thermal_stiffness_1, o.thermal_strength_1, o.thermal_friction_1}},
           {o.thermal_temperature_2, {o.thermal_stiffness_2, o.thermal_strength_2, o.thermal_friction_2}},
           {o.thermal_temperature_3, {o.thermal_stiffness_3, o.thermal_strength_3, o.thermal_friction_3}},
           {o.thermal_temperature_4, {o.thermal_stiffness_4, o.thermal_strength_4, o.thermal_friction_4}},
           {o.thermal_temperature_5, {o.thermal_stiffness_5, o.thermal_strength_5, o.thermal_friction_5}}};
  rows_.resize(static_cast<std::size_t>(o.thermal_table_rows));
}

MicroFactors MicroTable::at(double temperature) const {
  if (rows_.empty()) return {};
  std::size_t above = 1;
  while (above + 1 < rows_.size() && rows_[above].temperature < temperature) ++above;
  const Row &low = rows_[above - 1], &high = rows_[above];
  const double share =
      std::clamp((temperature - low.temperature) / (high.temperature - low.temperature), 0.0, 1.0);
  const auto between = [&](double a, double b) { return a + share * (b - a); };
  return {between(low.factors.stiffness, high.factors.stiffness),
          between(low.factors.strength, high.factors.strength),
          between(low.factors.friction, high.factors.friction)};
}

void MicroTable::require(double temperature, const std::string& what) const {
  // The range of the options that give temperatures.
  constexpr double coldest = 1.0, hottest = 5000.0;
  if (!std::isfinite(temperature) || temperature < coldest || temperature > hottest) {
    throw Error(ErrorKind::argument, what + " is " + number_text(temperature) +
                                         " K; it must lie between 1 and 5000 K (0 degrees C is 273.15 K).");
  }
  if (rows_.empty()) return;
  const double lowest = rows_.front().temperature, highest = rows_.back().temperature;
  if (temperature >= lowest && temperature <= highest) return;
  throw Error(ErrorKind::argument,
              what + " is " + number_text(temperature) + " K, outside the table of micro-parameters, " +
                  number_text(lowest) + " to " + number_text(highest) +
                  " K; add a row to the table (thermal.table_rows and thermal.temperature_1 to _5), or set "
                  "thermal.parameters = \"constant\".");
}

}  // namespace hfrac
