// SPDX-License-Identifier: BSD-3-Clause
#include "number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace hfrac::viz {

namespace {

std::string fixed(double value, int decimals) {
  return fmt::format("{:.{}f}", value, decimals);
}

}  // namespace

std::string value_text(double value) {
  if (!std::isfinite(value)) return "?";
  const double size = std::fabs(value);
  if (size >= 1000 && size < 1e6) return fixed(value, 0);  // the general format would write 1.23e+03
  return fmt::format("{:.3g}", value);
}

std::string time_text(double seconds) {
  struct Unit {
    double from;
    double size;
    const char* name;
  };
  static constexpr std::array<Unit, 6> units = {{{2 * 86400.0, 86400.0, "d"},
                                                 {2 * 3600.0, 3600.0, "h"},
                                                 {600.0, 60.0, "min"},
                                                 {0.1, 1.0, "s"},
                                                 {1e-4, 1e-3, "ms"},
                                                 {1e-30, 1e-6, "\xC2\xB5s"}}};
  const double size = std::fabs(seconds);
  for (const Unit& unit : units) {
    if (size >= unit.from) return value_text(seconds / unit.size) + " " + unit.name;
  }
  return "0 s";
}

std::string count_text(std::int64_t count) {
  std::string digits = std::to_string(count < 0 ? -count : count);
  for (std::size_t i = digits.size(); i > 3;) {
    i -= 3;
    digits.insert(i, "\xE2\x80\x89");
  }
  return count < 0 ? "-" + digits : digits;
}

std::string counted(std::int64_t count, const std::string& singular) {
  return count_text(count) + " " + singular + (count == 1 ? "" : "s");
}

double round_length(double limit) {
  if (!(limit > 0) || !std::isfinite(limit)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * decade <= limit * (1 + 1e-9)) return factor * decade;
  }
  return decade;
}

std::vector<Tick> round_ticks(double lowest, double highest, int wanted) {
  std::vector<Tick> ticks;
  const double range = highest - lowest;
  if (!(range > 0) || !std::isfinite(range)) return {{lowest, value_text(lowest)}};
  double step = round_length(range / std::max(1, wanted));
  while (range / step > wanted * 1.6) step = round_length(step * 2.6);
  const double slack = range * 1e-6;
  // A scale needs two: of -4.9 to 4.9 steps of 5 meet 0 alone.
  while (std::floor((highest + slack) / step) - std::ceil((lowest - slack) / step) < 1)
    step = round_length(0.99 * step);
  const int decimals = std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 9);
  const double first = std::ceil((lowest - slack) / step);
  for (int i = 0; i < 100; ++i) {
    const double value = (first + i) * step;
    if (value > highest + slack) break;
    ticks.push_back({value, fixed(value == 0 ? 0.0 : value, decimals)});
  }
  return ticks;
}

namespace {

// One way to show an SI unit: used from this size on.
struct Shown {
  double from;
  double scale;
  const char* unit;
};

constexpr double millidarcy = 9.869233e-16;  // [m2]

constexpr std::array<Shown, 4> pascals = {
    {{1e9, 1e-9, "GPa"}, {1e5, 1e-6, "MPa"}, {1e2, 1e-3, "kPa"}, {0, 1, "Pa"}}};
constexpr std::array<Shown, 4> metres = {
    {{1e4, 1e-3, "km"}, {0.5, 1, "m"}, {5e-4, 1e3, "mm"}, {0, 1e6, "\xC2\xB5m"}}};
constexpr std::array<Shown, 3> permeabilities = {
    {{1e-5, 1, "m\xC2\xB2"}, {1e-9, 1e6, "mm\xC2\xB2"}, {0, 1 / millidarcy, "mD"}}};
constexpr std::array<Shown, 3> square_metres = {
    {{1e-3, 1, "m\xC2\xB2"}, {1e-9, 1e6, "mm\xC2\xB2"}, {0, 1e12, "\xC2\xB5m\xC2\xB2"}}};
constexpr std::array<Shown, 5> seconds = {{{2 * 86400.0, 1 / 86400.0, "d"},
                                           {2 * 3600.0, 1 / 3600.0, "h"},
                                           {600, 1 / 60.0, "min"},
                                           {0.1, 1, "s"},
                                           {0, 1e3, "ms"}}};
constexpr std::array<Shown, 4> joules = {
    {{1e6, 1e-6, "MJ/m"}, {1e3, 1e-3, "kJ/m"}, {1e-3, 1, "J/m"}, {0, 1, "J/m"}}};
constexpr std::array<Shown, 4> newtons = {
    {{1e9, 1e-9, "GN"}, {1e5, 1e-6, "MN"}, {1e2, 1e-3, "kN"}, {0, 1, "N"}}};
constexpr std::array<Shown, 4> stiffnesses = {
    {{1e9, 1e-9, "GN/m"}, {1e5, 1e-6, "MN/m"}, {1e2, 1e-3, "kN/m"}, {0, 1, "N/m"}}};
constexpr std::array<Shown, 2> radians = {{{0.5, 1, "rad"}, {0, 1e3, "mrad"}}};
constexpr std::array<Shown, 1> kelvins = {{{0, 1, "K"}}};
constexpr std::array<Shown, 1> celsius = {{{0, 1,
                                            "\xC2\xB0"
                                            "C"}}};
constexpr std::array<Shown, 3> rates = {
    {{1e-2, 1, "m\xC2\xB2/s"}, {1e-8, 1e6, "mm\xC2\xB2/s"}, {0, 1e12, "\xC2\xB5m\xC2\xB2/s"}}};
constexpr std::array<Shown, 1> speeds = {{{0, 1, "m/s"}}};
constexpr std::array<Shown, 1> viscosities = {{{0, 1, "Pa s"}}};
constexpr std::array<Shown, 1> injectivities = {{{0, 1, "m\xC2\xB2/(Pa s)"}}};
constexpr std::array<Shown, 1> densities = {{{0, 1, "kg/m\xC2\xB3"}}};
constexpr std::array<Shown, 4> moments = {
    {{1e9, 1e-9, "GN m"}, {1e5, 1e-6, "MN m"}, {1e2, 1e-3, "kN m"}, {0, 1, "N m"}}};

struct Ending {
  std::string_view text;
  std::span<const Shown> ways;
};

// Longer endings before those they end with.
const std::array<Ending, 17>& endings() {
  static const std::array<Ending, 17> all = {{{"_m2_per_Pa_s", injectivities},
                                              {"_m2_per_s", rates},
                                              {"_m_per_s", speeds},
                                              {"_J_per_m", joules},
                                              {"_N_per_m", stiffnesses},
                                              {"_kg_per_m3", densities},
                                              {"_Pa_s", viscosities},
                                              {"_N_m", moments},
                                              {"_degC", celsius},
                                              {"_rad", radians},
                                              {"_Pa", pascals},
                                              {"_m2", square_metres},
                                              {"_K", kelvins},
                                              {"_N", newtons},
                                              {"_m", metres},
                                              {"_s", seconds},
                                              {"_J", joules}}};
  return all;
}

// "well[0].ramp_per_step" -> "well ramp per step"; the names of the far field's stresses keep their letters.
std::string readable(std::string name) {
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"stress.sigma_", "\xCF\x83_"},
                                 {"sigma_", "\xCF\x83_"},
                                 {"[0]", ""}}) {
    if (const std::size_t at = name.find(from); at != std::string::npos) name.replace(at, from.size(), to);
  }
  const bool symbol = name.starts_with("\xCF\x83_");
  std::replace(name.begin(), name.end(), '.', ' ');
  if (!symbol) std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace

Quantity quantity_of(const std::string& column, double largest) {
  if (column.ends_with(")")) {
    const std::size_t open = column.rfind(" (");
    if (open != std::string::npos) {
      return {column.substr(0, open), column.substr(open + 2, column.size() - open - 3), 1};
    }
  }
  for (const Ending& ending : endings()) {
    if (!column.ends_with(ending.text)) continue;
    // A permeability is an area too, and is told in darcys.
    const bool permeable = ending.text == "_m2" && column.find("permeability") != std::string::npos;
    const std::span<const Shown> ways = permeable ? permeabilities : ending.ways;
    Shown way = ways.back();
    for (const Shown& one : ways) {
      if (std::fabs(largest) < one.from) continue;
      way = one;
      break;
    }
    return {readable(column.substr(0, column.size() - ending.text.size())), way.unit, way.scale};
  }
  return {readable(column), "", 1};
}

std::string quantity_text(const std::string& column, double value) {
  const Quantity quantity = quantity_of(column, value);
  const std::string number = value_text(value * quantity.scale);
  return quantity.unit.empty() ? number : number + " " + quantity.unit;
}

}  // namespace hfrac::viz
