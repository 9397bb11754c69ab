// SPDX-License-Identifier: BSD-3-Clause
// A CSV file of the run folder in memory: columns by name. Cells that are no numbers read as NaN, and a last
// line that is still being written is left out, so a running job can be plotted at any moment.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hfrac::viz {

class TableFile {
 public:
  // An empty table if the file does not exist. Throws Failure(HFRAC_VIZ_ERR_READ) if it cannot be read.
  explicit TableFile(const std::filesystem::path& path);

  std::size_t rows() const { return rows_; }
  // Of the columns, in the file's order.
  const std::vector<std::string>& names() const { return names_; }
  bool has(const std::string& column) const { return columns_.count(column) != 0; }
  // As long as there are rows; all NaN if there is no such column.
  std::vector<double> numbers(const std::string& column) const;
  // For the columns that hold words; empty texts if there is no such column.
  std::vector<std::string> words(const std::string& column) const;

 private:
  std::size_t rows_ = 0;
  std::vector<std::string> names_;
  std::map<std::string, std::vector<std::string>> columns_;
};

}  // namespace hfrac::viz
