// SPDX-License-Identifier: BSD-3-Clause
// `hfrac plot --compare`: a table out of several run folders, or one that is there, and its picture.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "command/exit_code.hpp"
#include "command/paper.hpp"

namespace hfrac::command {

struct CompareRequest {
  std::vector<std::string> sources;     ///< run folders, or a single .csv file; empty: nothing to compare
  std::string x;                        ///< key of an option, or "step" or "time": the course of the runs
  std::vector<std::string> quantities;  ///< up to 6
  std::string series;                   ///< key of an option; empty: one series
  std::string target = "comparison.png";
  std::string title;
};

void add_compare_options(CLI::App& command, CompareRequest& request, CLI::Option* folder);

/** Draws the picture, and writes the table beside it if it was made from runs. Throws BadInput or std::runtime_error. */
void draw_comparison(const CompareRequest& request, const Paper& paper);

}  // namespace hfrac::command
