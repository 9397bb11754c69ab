// SPDX-License-Identifier: BSD-3-Clause
#include "table_file.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <system_error>

#include "failure.h"

namespace hfrac::viz {
namespace {

// The tables of a run have no quoted cells.
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char letter : line) {
    if (letter == ',') {
      cells.emplace_back();
    } else if (letter != '\r') {
      cells.back() += letter;
    }
  }
  return cells;
}

double number(const std::string& cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool whole = error == std::errc() && end == cell.data() + cell.size();
  return whole ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

TableFile::TableFile(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail_reading("cannot read " + path.string());
  std::stringstream content;
  content << file.rdbuf();
  std::string line;
  if (!std::getline(content, line)) return;
  names_ = split(line);
  while (std::getline(content, line)) {
    std::vector<std::string> cells = split(line);
    if (content.eof() || cells.size() != names_.size()) continue;  // not whole
    for (std::size_t i = 0; i < names_.size(); ++i) columns_[names_[i]].push_back(std::move(cells[i]));
    ++rows_;
  }
}

std::vector<double> TableFile::numbers(const std::string& column) const {
  std::vector<double> values(rows_, std::numeric_limits<double>::quiet_NaN());
  const auto found = columns_.find(column);
  if (found == columns_.end()) return values;
  for (std::size_t i = 0; i < rows_; ++i) values[i] = number(found->second[i]);
  return values;
}

std::vector<std::string> TableFile::words(const std::string& column) const {
  const auto found = columns_.find(column);
  return found != columns_.end() ? found->second : std::vector<std::string>(rows_);
}

}  // namespace hfrac::viz
