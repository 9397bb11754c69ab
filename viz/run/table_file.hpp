// SPDX-License-Identifier: BSD-3-Clause
// A CSV file of the run folder: columns by name, read and written.
//
// Read, a last line that is still being written is left out, so a running job can be plotted at any moment. Anything else that
// is not as it should be is an error that names file, line and column: a line with too few cells, a word where a number
// belongs, a column that is not there.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace hfrac::run {

class TableFile {
 public:
  /** Throws ReadError if the file is missing or damaged, as all below do. */
  explicit TableFile(std::filesystem::path path);

  size_t rows() const { return cells_.size(); }
  const std::filesystem::path& path() const { return path_; }
  /** Of the columns, in the file's order. */
  const std::vector<std::string>& names() const { return names_; }
  bool has(std::string_view column) const;
  /** As long as there are rows; an empty cell is NaN. */
  std::vector<double> numbers(std::string_view column) const;
  std::vector<std::string> words(std::string_view column) const;

 private:
  size_t place_of(std::string_view column) const;

  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> cells_;
};

/** The cells of a line, separated by commas; none of ours is quoted. */
std::vector<std::string> cells_of(std::string_view line);

/** A table being written. `visit` of the functions that list an item's columns calls it with each name and value. */
class TableText {
 public:
  /** Adds a line of the names, before any row. */
  template <class Columns>
  void head(const Columns& columns) {
    columns([this](const auto& name, const auto&) { this->cell(name); });
    end_line();
  }
  template <class Columns>
  void row(const Columns& columns) {
    columns([this](const auto&, const auto& value) { this->cell(value); });
    end_line();
  }
  template <class Value>
  void cell(const Value& value) {
    fmt::format_to(std::back_inserter(text_), "{}{}", begun_ ? "," : "", value);
    begun_ = true;
  }
  void end_line() {
    text_ += '\n';
    begun_ = false;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
  bool begun_ = false;
};

}  // namespace hfrac::run
