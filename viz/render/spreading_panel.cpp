// SPDX-License-Identifier: BSD-3-Clause
// How far from the well events were, against time: the r-t plot of Shapiro, Huenges and Borm (1997, Geophys. J. Int. 131, F15-F18).
//
// Pressure that diffuses from a point has reached about r = sqrt(4 pi D t) at time t, so events that it triggers lie below that curve, and the
// D whose curve holds them is an estimate of the rock's hydraulic diffusivity. D is given, or the one with 95 % of the events under its curve.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "charts.h"

namespace hfrac::viz {
namespace {

constexpr double share_below = 0.95;

// The diffusivity of the curve through an event [m2/s].
double diffusivity_of(const DistantEvent& event) {
  return event.distance * event.distance / (4 * std::numbers::pi * event.time);
}

// The smallest D that at least that share of the events ask for; 0 without events after the start.
double enclosing_diffusivity(const std::vector<DistantEvent>& events) {
  std::vector<double> wanted;
  for (const DistantEvent& event : events)
    if (event.time > 0) wanted.push_back(diffusivity_of(event));
  if (wanted.empty()) return 0;
  std::sort(wanted.begin(), wanted.end());
  const auto below = static_cast<std::size_t>(std::ceil(share_below * static_cast<double>(wanted.size())));
  return wanted[std::max<std::size_t>(below, 1) - 1];
}

ChartSeries front(double diffusivity, bool given, double last) {
  constexpr int points = 200;
  ChartSeries curve{
      "r = \xE2\x88\x9A(4\xCF\x80"
      "Dt), D = " +
          value_text(diffusivity) + " m\xC2\xB2/s" +
          (given ? "" : " (95 % of the events below; Shapiro et al. 1997)"),
      "",
      palette().faint_ink,
      {},
      {}};
  for (int k = 0; k <= points; ++k) {
    const double share = static_cast<double>(k) / points;
    const double time = last * share * share;  // close together where the curve is steep
    curve.x.push_back(time);
    curve.y.push_back(std::sqrt(4 * std::numbers::pi * diffusivity * time));
  }
  return curve;
}

}  // namespace

Panel spreading_panel(const std::vector<DistantEvent>& events, const std::vector<Colour>& colours,
                      double diffusivity) {
  Panel panel{"Distance from the well", "time (s)", {}, false, false};
  panel.unit = "m";
  for (const Colour colour : colours) {
    panel.series.push_back({"", "", colour, {}, {}});
    panel.series.back().dots = true;
  }
  double last = 0;
  for (const DistantEvent& event : events) {
    if (!(event.time > 0)) continue;
    panel.series[event.kind].x.push_back(event.time);
    panel.series[event.kind].y.push_back(event.distance);
    last = std::max(last, event.time);
  }
  std::erase_if(panel.series, [](const ChartSeries& series) { return series.x.empty(); });
  const double used = diffusivity > 0 ? diffusivity : enclosing_diffusivity(events);
  if (used > 0 && last > 0) panel.series.push_back(front(used, diffusivity > 0, last));
  return panel;
}

}  // namespace hfrac::viz
