// SPDX-License-Identifier: BSD-3-Clause
// A record as a LAS 2.0 file (Canadian Well Logging Society 1992), read as leniently as lasio (Inverarity) reads one: sections by their first
// letter in either case, MNEM.UNIT DATA : DESCRIPTION by its first point, first blank and last colon, values between blanks or commas, wrapped
// or not. Curves whose mnemonic begins with TIME or ETIM, RATE or FLOW, PRES become the columns that record_columns.hpp knows, RATE.M3/MIN as
// rate_m3_min; a value that is the file's NULL is none.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hfrac::capi {

// Whether a text begins as such files do, with a section of the version.
bool is_las(std::string_view text);

class LasTable {
 public:
  explicit LasTable(const std::string& path) : path_(path) {}
  enum class Line { other, names, row };
  // One line after the other; after `names` and `row` the lists below are what they tell.
  Line take(std::string_view line, std::size_t number);
  [[nodiscard]] const std::vector<std::string_view>& names() const { return names_; }
  [[nodiscard]] const std::vector<std::string_view>& cells() const { return cells_; }

 private:
  void read_item(std::string_view line, std::size_t number);
  Line begin_values(std::size_t number);

  const std::string& path_;
  char section_ = ' ';
  bool wrapped_ = false;
  std::optional<double> null_;
  std::vector<std::string> curves_;
  std::vector<std::string_view> names_, cells_;
  bool row_complete_ = true;
};

}  // namespace hfrac::capi
