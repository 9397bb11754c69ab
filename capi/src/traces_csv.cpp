// SPDX-License-Identifier: BSD-3-Clause
// Traces as a table: a line of names, then a trace per line.
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "table_cells.hpp"
#include "trace_list.hpp"
#include "utf8.hpp"

namespace hfrac::capi {
namespace {

constexpr std::array<std::string_view, 4> wanted{"START_X", "START_Y", "END_X", "END_Y"};
using Columns = std::array<std::size_t, wanted.size()>;

Columns columns_of(const std::vector<std::string_view>& header, const TraceList& traces) {
  Columns columns{};
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto same = [&](std::string_view name) {
      return std::equal(name.begin(), name.end(), wanted[k].begin(), wanted[k].end(),
                        [](char a, char b) { return std::toupper(static_cast<unsigned char>(a)) == b; });
    };
    const auto found = std::find_if(header.begin(), header.end(), same);
    if (found == header.end())
      traces.refuse("no column " + std::string(wanted[k]) +
                    "; the first line of a table of traces names START_X, START_Y, END_X and END_Y, in m.");
    columns[k] = static_cast<std::size_t>(found - header.begin());
  }
  return columns;
}

double number_of(const std::vector<std::string_view>& cells, std::size_t column, std::string_view name,
                 const TraceList& traces) {
  if (column >= cells.size())
    traces.refuse("the line has " + std::to_string(cells.size()) + " values and none for " +
                  std::string(name) + ".");
  const std::string_view cell = cells[column];
  double value = 0.0;
  const auto [end, fault] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool whole = fault == std::errc() && end == cell.data() + cell.size();
  traces.check_coordinate(whole ? value : std::nan(""), name, cell);
  return value;
}

}  // namespace

void read_csv(std::string_view text, TraceList& traces) {
  bool headed = false;
  Columns columns{};
  for (std::size_t begin = 0; begin < text.size(); ++traces.line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trimmed(text.substr(begin, end - begin));
    begin = end + 1;
    if (line.empty() || line.front() == '#') continue;
    const auto cells = cells_of(line);
    if (!headed) {
      columns = columns_of(cells, traces);
      headed = true;
      continue;
    }
    std::array<double, wanted.size()> ends{};
    for (std::size_t k = 0; k < ends.size(); ++k) ends[k] = number_of(cells, columns[k], wanted[k], traces);
    traces.add({ends[0], ends[1]}, {ends[2], ends[3]});
  }
  traces.line = 1;
  if (!headed) traces.refuse("the table of traces is empty; its first line names its columns.");
}

}  // namespace hfrac::capi
