// SPDX-License-Identifier: BSD-3-Clause
#include "run/table_file.hpp"

#include <algorithm>
#include <limits>

#include "run/files.hpp"
#include "run/text.hpp"

namespace hfrac::run {

std::vector<std::string> cells_of(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string> cells;
  for (;;) {
    const size_t comma = line.find(',');
    cells.emplace_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

TableFile::TableFile(std::filesystem::path path) : path_(std::move(path)) {
  const std::string content = read_whole(path_);
  std::string_view rest = content;
  for (size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    auto cells = cells_of(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    if (names_.empty()) {
      names_ = std::move(cells);
    } else if (cells.size() == names_.size()) {
      cells_.push_back(std::move(cells));
    } else {
      fail_reading(fmt::format("'{}' is damaged: line {} has {} cells, and there are {} columns",
                               path_.string(), cells_.size() + 2, cells.size(), names_.size()));
    }
  }
  if (names_.empty()) fail_reading(fmt::format("'{}' is no table: it has no line of names", path_.string()));
}

bool TableFile::has(std::string_view column) const {
  return std::find(names_.begin(), names_.end(), column) != names_.end();
}

size_t TableFile::place_of(std::string_view column) const {
  const auto found = std::find(names_.begin(), names_.end(), column);
  if (found == names_.end())
    fail_reading(fmt::format("'{}' has no column '{}': it is damaged, or another version of hfrac wrote it",
                             path_.string(), column));
  return static_cast<size_t>(found - names_.begin());
}

std::vector<double> TableFile::numbers(std::string_view column) const {
  const size_t place = place_of(column);
  std::vector<double> values;
  values.reserve(cells_.size());
  for (size_t row = 0; row < cells_.size(); ++row) {
    const auto& cell = cells_[row][place];
    const auto value = cell.empty() ? std::numeric_limits<double>::quiet_NaN() : number_in<double>(cell);
    if (!value)
      fail_reading(fmt::format("'{}' is damaged: '{}' in line {}, column '{}', is no number", path_.string(),
                               printable(cell.substr(0, 40)), row + 2, column));
    values.push_back(*value);
  }
  return values;
}

std::vector<std::string> TableFile::words(std::string_view column) const {
  const size_t place = place_of(column);
  std::vector<std::string> words;
  for (const auto& row : cells_) words.push_back(row[place]);
  return words;
}

}  // namespace hfrac::run
