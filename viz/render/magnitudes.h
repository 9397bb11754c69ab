// SPDX-License-Identifier: BSD-3-Clause
// What both kinds of events, single cracks and those of the catalogue, are plotted as: strength over time, and how many
// are at least as strong, with the line log10 N = a - b M of Gutenberg and Richter.
#pragma once

#include <string>
#include <vector>

#include "chart_page.h"

namespace hfrac::viz {

// Dots of magnitudes, a series for each kind of event; a kind without any is left out.
Panel course_panel(std::vector<ChartSeries> kinds);

// The number of events over the magnitude, and the law's line if there are events enough to tell it.
Panel frequency_panel(const std::string& title, std::vector<double> magnitudes);

}  // namespace hfrac::viz
