// SPDX-License-Identifier: BSD-3-Clause
#include "frequency.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace hfrac::viz {

Frequency frequency_of(const std::vector<double>& magnitudes) {
  constexpr double fewest = 10;
  std::map<long, int> tenths;
  for (const double magnitude : magnitudes) ++tenths[std::lround(std::floor(10 * magnitude))];
  Frequency found;
  int most = 0;
  for (const auto& [tenth, count] : tenths) {
    if (count <= most) continue;
    most = count;
    found.from = static_cast<double>(tenth) / 10;
  }
  double sum = 0;
  for (const double magnitude : magnitudes) {
    if (magnitude < found.from) continue;
    sum += magnitude - found.from;
    ++found.count;
  }
  if (found.count < fewest || !(sum > 0)) return found;
  found.b = std::numbers::log10e * found.count / sum;
  found.b_error = found.b / std::sqrt(found.count);
  return found;
}

Panel frequency_panel(const std::string& title, std::vector<double> magnitudes) {
  std::sort(magnitudes.begin(), magnitudes.end());
  ChartSeries frequency{"", "", palette().water, {}, {}};
  frequency.dots = true;
  for (std::size_t i = 0; i < magnitudes.size(); ++i) {
    frequency.x.push_back(magnitudes[i]);
    frequency.y.push_back(static_cast<double>(magnitudes.size() - i));
  }
  Panel panel{title, "magnitude", {frequency}, true, false};
  const Frequency line = frequency_of(magnitudes);
  if (!(line.b > 0)) return panel;
  ChartSeries fit{"b = " + value_text(line.b) + " \xC2\xB1 " + value_text(line.b_error) + " above M " +
                      value_text(line.from) + " (Aki 1965)",
                  "",
                  palette().pull,
                  {},
                  {}};
  fit.x = {line.from, line.from + std::log10(line.count) / line.b};
  fit.y = {line.count, 1};
  panel.series.push_back(std::move(fit));
  return panel;
}

}  // namespace hfrac::viz
