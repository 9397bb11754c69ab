// SPDX-License-Identifier: BSD-3-Clause
// Several runs against each other: a table of (series, x, values), one line per run or per moment of a run, turned into
// curves of means with their spread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hfrac/viz.h"
#include "run/table_file.hpp"

namespace hfrac::viz {

// All runs of one series at one x.
struct ComparedPoint {
  double x = 0;
  std::vector<double> values;
  double mean = 0;
  double spread = 0;  // standard deviation of `values`, or what the table says; NaN: unknown
};

struct ComparedSeries {
  std::string name;                   // as shown
  double order = 0;                   // number of the series if it is one, otherwise its place in the table
  bool number = false;                // whether it is a number
  std::vector<ComparedPoint> points;  // by rising x
};

// One quantity over x.
struct ComparedPanel {
  std::string column;
  std::vector<ComparedSeries> series;
};

struct Comparison {
  std::string series_label;
  std::string x_column;
  std::vector<ComparedPanel> panels;
  int most_runs = 0;  // at one point
  bool given_spread = false;
};

// The table's first column names the series, the second is x, each further one a quantity; NAME_spread is the
// half length of NAME's error bar. Throws ReadError.
Comparison read_comparison(const std::filesystem::path& table);

// The table's picture: .png, .svg or .pdf. `options` have been checked. Throws Failure or FileError.
void render_comparison(const std::filesystem::path& table, const std::filesystem::path& target,
                       const hfrac_viz_comparison_options& options);

}  // namespace hfrac::viz
