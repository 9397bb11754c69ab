// SPDX-License-Identifier: BSD-3-Clause
// How many events are at least as strong: the line log10 N = a - b M of Gutenberg and Richter.
#pragma once

#include <vector>

#include "chart_page.h"

namespace hfrac::viz {

struct Frequency {
  double from = 0;     // magnitude from which on the catalogue follows the line
  double b = 0;        // its slope, 0: too few events to tell
  double b_error = 0;  // its standard error
  double count = 0;    // of the events above `from`
};

// From the fullest tenth of a magnitude on (Wiemer and Wyss 2000: maximum curvature) by likelihood (Aki 1965).
Frequency frequency_of(const std::vector<double>& magnitudes);

// The number of events over the magnitude, and that line.
Panel frequency_panel(const std::string& title, std::vector<double> magnitudes);

}  // namespace hfrac::viz
