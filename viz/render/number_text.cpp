// SPDX-License-Identifier: BSD-3-Clause
#include "number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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
  const int decimals = std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 9);
  const double first = std::ceil((lowest - slack) / step);
  for (int i = 0; i < 100; ++i) {
    const double value = (first + i) * step;
    if (value > highest + slack) break;
    ticks.push_back({value, fixed(value == 0 ? 0.0 : value, decimals)});
  }
  return ticks;
}

}  // namespace hfrac::viz
