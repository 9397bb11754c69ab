// SPDX-License-Identifier: BSD-3-Clause
// `hfrac plot --compare`: a table out of several run folders, or one that is there, and its picture.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "command/drawing.hpp"
#include "command/exit_code.hpp"

namespace hfrac::command {

// What one run contributes to a comparison: options out of its case file, results out of its summary, history and
// fracture table.

/** What can be asked for with `--y`, one line per name. */
std::string quantity_help();

/** A finished or running run. Reading throws BadInput with the file and what is wrong in it. */
class ComparedRun {
 public:
  explicit ComparedRun(std::filesystem::path folder);

  /** An option of the case by its key, "title" included, as text that a table holds. */
  std::string option(const std::string& key) const;

  /** A result at the end of the run by one of our names, or a number of summary.json by its path, "setup.coordination". */
  double result(const std::string& name) const;

  /** A column of history.csv by one of our names or its own. */
  std::vector<double> course(const std::string& name) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  double initiation_pressure() const;

  std::filesystem::path folder_;
};

/** Column of the table for an option: its key with its unit, "bond.tensile_strength_Pa". */
std::string option_column(const std::string& key);
/** Column of the table for a result or, `over_time`, for a course. */
std::string result_column(const std::string& name, bool over_time);

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
