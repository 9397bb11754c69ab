// SPDX-License-Identifier: BSD-3-Clause
#include "magnitudes.h"

#include <hfrac/hfrac.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hfrac::viz {
namespace {

// The engine's (Aki 1965, from the fullest tenth of a magnitude on): the number printed by `hfrac catalogue`.
hfrac_magnitude_law law_of(const std::vector<double>& magnitudes) {
  hfrac_magnitude_law law{};
  law.struct_size = static_cast<std::int32_t>(sizeof law);
  const double fullest = std::numeric_limits<double>::quiet_NaN();
  if (hfrac_find_magnitude_law(magnitudes.data(), static_cast<std::int64_t>(magnitudes.size()), fullest,
                               &law) != HFRAC_OK)
    law.b = 0;
  return law;
}

}  // namespace

Panel course_panel(std::vector<ChartSeries> kinds) {
  Panel panel{"Magnitude against time", "time (s)", {}, false, false};
  panel.free_zero = true;
  for (ChartSeries& series : kinds) {
    if (series.x.empty()) continue;
    series.dots = true;
    panel.series.push_back(std::move(series));
  }
  return panel;
}

Panel frequency_panel(const std::string& title, std::vector<double> magnitudes) {
  constexpr std::int64_t fewest = 10;  // for a line
  std::sort(magnitudes.begin(), magnitudes.end());
  ChartSeries frequency{"", "", palette().water, {}, {}};
  frequency.dots = true;
  for (std::size_t i = 0; i < magnitudes.size(); ++i) {
    frequency.x.push_back(magnitudes[i]);
    frequency.y.push_back(static_cast<double>(magnitudes.size() - i));
  }
  Panel panel{title, "magnitude", {frequency}, true, false};
  const hfrac_magnitude_law law = law_of(magnitudes);
  if (!(law.b > 0) || law.count < fewest) return panel;
  ChartSeries line{"b = " + value_text(law.b) + " \xC2\xB1 " + value_text(law.b_error) + " above M " +
                       value_text(law.completeness) + " (Aki 1965)",
                   "",
                   palette().pull,
                   {},
                   {}};
  const auto count = static_cast<double>(law.count);
  line.x = {law.completeness, law.completeness + std::log10(count) / law.b};
  line.y = {count, 1};
  panel.series.push_back(std::move(line));
  return panel;
}

}  // namespace hfrac::viz
