// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "case_file.hpp"
#include "core/error.hpp"
#include "hfrac/record.h"
#include "internal.hpp"
#include "record_columns.hpp"
#include "record_las.hpp"
#include "table_cells.hpp"
#include "text_file.hpp"
#include "utf8.hpp"

namespace hfrac::capi {
namespace {

constexpr std::size_t most_rows = 1'000'000;
// As of a schedule's entry and of a well.
struct Bounds {
  double least, most;
  const char* shown;
};
constexpr Bounds times{0.0, 1e15, "0 to 1e15 s"};
constexpr Bounds rates{-1e6, 1e6, "-1e6 to 1e6 m2/s"};
constexpr Bounds pressures{-1e12, 1e12, "-1e12 to 1e12 Pa"};

class RecordReader {
 public:
  RecordReader(const std::string& path, const RecordWishes& wishes) : path_(path), wishes_(wishes) {}

  Record read(std::string_view text) {
    if (is_las(text)) las_.emplace(path_);
    for (std::size_t begin = 0; begin < text.size(); ++line_) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string_view line = trimmed(text.substr(begin, end - begin));
      begin = end + 1;
      if (line.empty() || line.front() == '#') continue;
      if (las_) {
        const auto told = las_->take(line, line_);
        if (told == LasTable::Line::names) name_columns(las_->names());
        if (told == LasTable::Line::row) add(las_->cells());
      } else if (const auto cells = cells_of(line); headed_) {
        add(cells);
      } else {
        name_columns(cells);
      }
    }
    if (!headed_)
      refuse_record(path_, 1,
                    las_ ? "the LAS file has no section ~A of values."
                         : "the record is empty; its first line names its columns.");
    if (record_.time.empty())
      refuse_record(path_, 1, "the record has no rows; below the line of names stands a row for each time.");
    return std::move(record_);
  }

 private:
  [[noreturn]] void refuse(const std::string& fault) const { refuse_record(path_, line_, fault); }

  void name_columns(const std::vector<std::string_view>& names) {
    columns_ = columns_of_record(names, wishes_, path_, line_);
    headed_ = true;
  }

  void add(const std::vector<std::string_view>& cells) {
    if (record_.time.size() == most_rows)
      refuse("more than " + std::to_string(most_rows) + " rows; log less often, or cut the record.");
    const std::string_view shown = cell(cells, columns_.time);
    const double time = columns_.time.dated ? date(shown) : number(cells, columns_.time, times);
    if (!record_.time.empty() && time <= record_.time.back())
      refuse(columns_.time.name + " = " + printable(shown) + " is not after " + printable(last_time_) +
             ", the time of the row before; rows stand in order of time.");
    last_time_ = shown;
    record_.time.push_back(time);
    if (columns_.rate) record_.rate.push_back(number(cells, *columns_.rate, rates));
    if (columns_.pressure) record_.pressure.push_back(number(cells, *columns_.pressure, pressures));
  }

  std::string_view cell(const std::vector<std::string_view>& cells, const RecordColumn& column) const {
    if (column.place >= cells.size() || cells[column.place].empty())
      refuse("the row has no " + column.name + "; fill it in, or leave the row out.");
    return cells[column.place];
  }

  double number(const std::vector<std::string_view>& cells, const RecordColumn& column,
                const Bounds& bounds) const {
    const std::string_view shown = cell(cells, column);
    double value = 0.0;
    const auto [end, fault] = std::from_chars(shown.data(), shown.data() + shown.size(), value);
    value *= column.scale;
    if (fault != std::errc() || end != shown.data() + shown.size() ||
        !(value >= bounds.least && value <= bounds.most))
      refuse(column.name + " = " + printable(shown) + " is not a number from " + bounds.shown + ".");
    return value;
  }

  // Seconds since the first row.
  double date(std::string_view shown) {
    const auto seconds = seconds_of_date(shown);
    if (!seconds)
      refuse("time = " + printable(shown) +
             " is not a time as ISO 8601 writes it, 2026-03-01T08:00:00; in seconds the column is time_s.");
    if (record_.time.empty()) first_date_ = *seconds;
    return *seconds - first_date_;
  }

  const std::string& path_;
  const RecordWishes& wishes_;
  std::size_t line_ = 1;
  bool headed_ = false;
  std::optional<LasTable> las_;
  RecordColumns columns_{};
  Record record_;
  std::string_view last_time_;
  double first_date_ = 0.0;
};

}  // namespace

Record read_record(const std::string& path, const RecordWishes& wishes) {
  const std::string text = read_text_file(path, record_limits);
  std::string_view content = text;
  if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);  // some programs begin UTF-8 so
  return RecordReader(path, wishes).read(content);
}

}  // namespace hfrac::capi

using namespace hfrac;
using namespace hfrac::capi;

std::int32_t hfrac_read_record(const char* path, double thickness, double* rows, std::int64_t capacity,
                               std::int64_t* count) {
  return guarded([&] {
    require_not_null(path, "path");
    require_not_null(count, "count");
    if (!(thickness > 0.0 && thickness <= 1e6))
      throw Error(ErrorKind::argument, "thickness is not a number above 0 to 1e6 m.");
    if (capacity < 0) throw Error(ErrorKind::argument, "capacity is negative.");
    std::string file = path;
    if (file.ends_with(".toml")) {
      const auto named = record_of_case(file);
      *count = 0;
      if (!named) return;
      file = named->path;
      if (named->thickness != 0.0) thickness = named->thickness;
    }
    const Record record = read_record(file, {Wish::if_there, Wish::if_there, thickness});
    *count = static_cast<std::int64_t>(record.time.size());
    if (rows == nullptr) return;
    const auto value = [](const std::vector<double>& of, std::size_t k) {
      return of.empty() ? std::numeric_limits<double>::quiet_NaN() : of[k];
    };
    for (std::size_t k = 0; k < static_cast<std::size_t>(std::min(capacity, *count)); ++k) {
      rows[3 * k] = record.time[k];
      rows[3 * k + 1] = value(record.rate, k);
      rows[3 * k + 2] = value(record.pressure, k);
    }
  });
}
