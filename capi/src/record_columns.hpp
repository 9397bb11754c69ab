// SPDX-License-Identifier: BSD-3-Clause
// Which column of a record holds what, and in which unit: told by the names in its first line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record.hpp"

namespace hfrac::capi {

// A fault of a record: file, line, sentence.
[[noreturn]] void refuse_record(const std::string& path, std::size_t line, const std::string& fault);

struct RecordColumn {
  std::size_t place = 0;
  std::string name;    // as in the file
  double scale = 1.0;  // of a number of the file, to SI
  bool dated = false;  // a time as a date
};
struct RecordColumns {
  RecordColumn time;
  std::optional<RecordColumn> rate, pressure;
};

RecordColumns columns_of_record(const std::vector<std::string_view>& header, const RecordWishes& wishes,
                                const std::string& path, std::size_t line);

// ISO 8601 as seconds since 1970; nothing if it is none.
std::optional<double> seconds_of_date(std::string_view text);

}  // namespace hfrac::capi
