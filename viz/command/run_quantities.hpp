// SPDX-License-Identifier: BSD-3-Clause
// What one run contributes to a comparison: options out of its case file, results out of its summary, history and
// fracture table.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hfrac::command {

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

}  // namespace hfrac::command
