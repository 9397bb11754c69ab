// SPDX-License-Identifier: BSD-3-Clause
#include "traces.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <string_view>

#include "core/error.hpp"
#include "text_file.hpp"
#include "utf8.hpp"

namespace hfrac::capi {
namespace {

constexpr std::size_t most_traces = 100'000;
constexpr std::array<std::string_view, 4> wanted{"START_X", "START_Y", "END_X", "END_Y"};

struct Place {
  const std::string& path;
  std::size_t line;
};

[[noreturn]] void refuse(const Place& at, const std::string& fault) {
  throw Error(ErrorKind::case_file, printable(at.path, 400) + ":" + std::to_string(at.line) + ": " + fault);
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const auto comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

using Columns = std::array<std::size_t, 4>;

Columns columns_of(const std::vector<std::string_view>& header, const Place& at) {
  Columns columns{};
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto same = [&](std::string_view name) {
      return std::equal(name.begin(), name.end(), wanted[k].begin(), wanted[k].end(),
                        [](char a, char b) { return std::toupper(static_cast<unsigned char>(a)) == b; });
    };
    const auto found = std::find_if(header.begin(), header.end(), same);
    if (found == header.end())
      refuse(at, "no column " + std::string(wanted[k]) +
                     "; the first line of a table of traces names START_X, START_Y, END_X and END_Y, in m.");
    columns[k] = static_cast<std::size_t>(found - header.begin());
  }
  return columns;
}

double number_of(const std::vector<std::string_view>& cells, std::size_t column, std::string_view name,
                 const Place& at) {
  if (column >= cells.size())
    refuse(at, "the line has " + std::to_string(cells.size()) + " values and none for " + std::string(name) +
                   ".");
  const std::string_view cell = cells[column];
  double value = 0.0;
  const auto [end, fault] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  constexpr double farthest = 1e6;  // m, as of a joint's ends
  if (fault != std::errc() || end != cell.data() + cell.size() || !(std::abs(value) <= farthest))
    refuse(at, std::string(name) + " = " + printable(cell) + " is not a number from -1e6 to 1e6 m.");
  return value;
}

}  // namespace

std::string beside(const std::string& case_file, const std::string& path) {
  const std::filesystem::path given(path);
  return given.is_absolute() ? path : (std::filesystem::path(case_file).parent_path() / given).string();
}

std::vector<JointOptions> read_traces(const std::string& path, const JointOptions& like) {
  const std::string text = read_text_file(path);
  std::vector<JointOptions> joints;
  bool headed = false;
  Columns columns{};
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trimmed(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
    const Place at{path, number + 1};
    if (line.empty() || line.front() == '#') continue;
    const auto cells = cells_of(line);
    if (!headed) {
      columns = columns_of(cells, at);
      headed = true;
      continue;
    }
    if (joints.size() == most_traces)
      refuse(at, "more than " + std::to_string(most_traces) + " traces; leave out the shortest.");
    JointOptions joint = like;
    double* to[] = {&joint.x1, &joint.y1, &joint.x2, &joint.y2};
    for (std::size_t k = 0; k < wanted.size(); ++k) *to[k] = number_of(cells, columns[k], wanted[k], at);
    if (joint.x1 == joint.x2 && joint.y1 == joint.y2)
      refuse(at, "the trace has no length: both ends are at the same place.");
    joints.push_back(joint);
  }
  if (!headed) refuse({path, 1}, "the table of traces is empty; its first line names its columns.");
  return joints;
}

}  // namespace hfrac::capi
