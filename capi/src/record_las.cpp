// SPDX-License-Identifier: BSD-3-Clause
#include "record_las.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "record_columns.hpp"
#include "table_cells.hpp"
#include "utf8.hpp"

namespace hfrac::capi {
namespace {

char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
std::string in_capitals(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), upper);
  return result;
}

std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// A curve as a column: what its mnemonic begins with, and its unit as columns spell it. Another curve is a column of no meaning.
std::string column_name(std::string_view mnemonic, std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> quantities{
      {{"TIME", "time"}, {"ETIM", "time"}, {"RATE", "rate"}, {"FLOW", "rate"}, {"PRES", "pressure"}}};
  constexpr std::array<std::pair<std::string_view, std::string_view>, 27> units{{{"S", "s"},
                                                                                 {"SEC", "s"},
                                                                                 {"MIN", "min"},
                                                                                 {"H", "h"},
                                                                                 {"HR", "h"},
                                                                                 {"D", "d"},
                                                                                 {"DAY", "d"},
                                                                                 {"M2/S", "m2_s"},
                                                                                 {"M3/S", "m3_s"},
                                                                                 {"M3/MIN", "m3_min"},
                                                                                 {"M3/H", "m3_h"},
                                                                                 {"M3/HR", "m3_h"},
                                                                                 {"L/S", "L_s"},
                                                                                 {"L/SEC", "L_s"},
                                                                                 {"L/MIN", "L_min"},
                                                                                 {"PA", "Pa"},
                                                                                 {"KPA", "kPa"},
                                                                                 {"MPA", "MPa"},
                                                                                 {"BAR", "bar"},
                                                                                 {"M3/SEC", "m3_s"},
                                                                                 {"BBL/MIN", "bbl_min"},
                                                                                 {"BPM", "bbl_min"},
                                                                                 {"GAL/MIN", "gal_min"},
                                                                                 {"GPM", "gal_min"},
                                                                                 {"PSI", "psi"},
                                                                                 {"PSIA", "psi"},
                                                                                 {"BARA", "bar"}}};
  const std::string name = in_capitals(mnemonic), spelt = in_capitals(unit);
  for (const auto& [begins, quantity] : quantities) {
    if (!name.starts_with(begins)) continue;
    if (spelt.empty()) return std::string(quantity);
    const auto known =
        std::find_if(units.begin(), units.end(), [&](const auto& u) { return u.first == spelt; });
    return std::string(quantity) + "_" +
           (known != units.end() ? std::string(known->second) : std::string(unit));
  }
  return "curve_" + std::string(mnemonic);
}

}  // namespace

bool is_las(std::string_view text) {
  while (!text.empty()) {
    const auto end = text.find('\n');
    const std::string_view line = trimmed(text.substr(0, end));
    if (!line.empty() && line.front() != '#')
      return line.size() > 1 && line[0] == '~' && upper(line[1]) == 'V';
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return false;
}

LasTable::Line LasTable::take(std::string_view line, std::size_t number) {
  if (line.front() == '~') {
    section_ = line.size() > 1 ? upper(line[1]) : ' ';
    return section_ == 'A' ? begin_values(number) : Line::other;
  }
  if (section_ == 'A') {
    if (row_complete_) cells_.clear();
    constexpr std::string_view between = " \t,";
    while (true) {
      const auto begin = line.find_first_not_of(between);
      if (begin == std::string_view::npos) break;
      line.remove_prefix(begin);
      const auto length = std::min(line.find_first_of(between), line.size());
      const std::string_view cell = line.substr(0, length);
      const auto value = null_ ? number_of(cell) : std::nullopt;
      cells_.push_back(value && *value == *null_ ? std::string_view{} : cell);
      line.remove_prefix(length);
    }
    row_complete_ = !wrapped_ || cells_.size() >= names_.size();
    return row_complete_ ? Line::row : Line::other;
  }
  if (section_ == 'V' || section_ == 'W' || section_ == 'C') read_item(line, number);
  return Line::other;
}

void LasTable::read_item(std::string_view line, std::size_t number) {
  const auto point = line.find('.');
  if (point == std::string_view::npos)
    refuse_record(path_, number,
                  printable(line.substr(0, 40)) + " is no item of a LAS file, MNEM.UNIT DATA : DESCRIPTION.");
  const std::string_view mnemonic = trimmed(line.substr(0, point));
  const std::string_view rest = line.substr(point + 1);
  const std::string_view unit = rest.substr(0, rest.find_first_of(" \t:"));
  const std::string_view data = trimmed(rest.substr(unit.size(), rest.rfind(':') - unit.size()));
  const std::string name = in_capitals(mnemonic);
  if (section_ == 'C') {
    curves_.push_back(column_name(mnemonic, unit));
    return;
  }
  const std::string_view value = data.empty() ? unit : data;  // VERS.2.0: these have no unit
  if (name == "VERS") {
    const auto version = number_of(value);
    if (!version || (*version != 2.0 && *version != 1.2))
      refuse_record(path_, number,
                    "VERS = " + printable(value) + "; LAS files of version 2.0 and 1.2 are read.");
  } else if (name == "WRAP") {
    wrapped_ = in_capitals(value) == "YES";
  } else if (name == "NULL") {
    null_ = number_of(value);
  }
}

LasTable::Line LasTable::begin_values(std::size_t number) {
  if (curves_.empty())
    refuse_record(path_, number, "no curves: a section ~C before the values names them, RATE.M3/MIN.");
  names_.assign(curves_.begin(), curves_.end());
  return Line::names;
}

}  // namespace hfrac::capi
