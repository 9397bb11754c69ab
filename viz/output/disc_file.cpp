// SPDX-License-Identifier: BSD-3-Clause
#include "output/disc_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "run/grid_file.hpp"
#include "run/text.hpp"

namespace hfrac::output {
namespace {

constexpr std::array<std::string_view, 3> disc_columns{"x", "y", "radius"};
constexpr std::array<std::string_view, 3> bond_columns{"disc_0", "disc_1", "state"};

bool is_separator(char c) {
  return c == ',' || c == ';' || c == ' ' || c == '\t' || c == '\r';
}

/** The words of a line; between commas or semicolons there is one word each, may it be empty. */
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const auto begin =
        std::find_if(line.begin(), line.end(), [](char c) { return c != ' ' && c != '\t' && c != '\r'; });
    line.remove_prefix(static_cast<std::size_t>(begin - line.begin()));
    if (line.empty()) break;
    const auto end = std::find_if(line.begin(), line.end(), is_separator);
    words.push_back(line.substr(0, static_cast<std::size_t>(end - line.begin())));
    line.remove_prefix(words.back().size());
    const auto next =
        std::find_if(line.begin(), line.end(), [](char c) { return c != ' ' && c != '\t' && c != '\r'; });
    line.remove_prefix(static_cast<std::size_t>(next - line.begin()));
    if (!line.empty() && (line.front() == ',' || line.front() == ';')) line.remove_prefix(1);
  }
  return words;
}

bool is_name(std::string_view word, std::string_view name) {
  return word == name || (word.size() == name.size() + 2 && word.starts_with(name) && word.ends_with("_m"));
}

/** Calls take(line number, words) for every line of values, each with the words of the columns `wanted`, in that order; those
 * from `optional` on are empty if the file has no such column. */
template <class Take>
void read_columns(const std::filesystem::path& file, std::span<const std::string_view> wanted,
                  size_t optional, Take take) {
  std::ifstream stream(file);
  if (!stream) throw DiscFileError(fmt::format("cannot read '{}'", file.string()));
  std::vector<size_t> column;
  std::vector<std::string_view> row(wanted.size());
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    const auto words = words_of(line);
    if (words.empty() || words.front().starts_with('#')) continue;
    if (column.empty()) {
      for (size_t k = 0; k < wanted.size(); ++k) {
        const auto at =
            std::find_if(words.begin(), words.end(), [&](auto word) { return is_name(word, wanted[k]); });
        if (at == words.end() && k < optional)
          throw DiscFileError(fmt::format("{}:{}: no column {}; the first line names the columns {}",
                                          file.string(), number, wanted[k],
                                          fmt::join(wanted.first(optional), ", ")));
        column.push_back(static_cast<std::size_t>(at - words.begin()));
      }
      continue;
    }
    for (size_t k = 0; k < wanted.size(); ++k)
      row[k] = column[k] < words.size() ? words[column[k]] : std::string_view{};
    take(number, row);
  }
}

/** A number that is the whole word. */
template <class Number>
Number number_of(std::string_view word, const std::filesystem::path& file, size_t line,
                 std::string_view column) {
  const auto value = run::number_in<Number>(word);
  if (!value)
    throw DiscFileError(fmt::format("{}:{}: {} is '{}', not a{} number", file.string(), line, column,
                                    run::printable(word.substr(0, 40)),
                                    std::is_integral_v<Number> ? " whole" : ""));
  return *value;
}

std::vector<double> read_csv(const std::filesystem::path& file) {
  std::vector<double> discs;
  read_columns(file, disc_columns, disc_columns.size(), [&](size_t line, const auto& words) {
    for (size_t k = 0; k < 3; ++k) discs.push_back(number_of<double>(words[k], file, line, disc_columns[k]));
  });
  if (discs.empty()) throw DiscFileError(fmt::format("{}: no discs in it", file.string()));
  return discs;
}

std::vector<double> read_vtu(const std::filesystem::path& file) {
  const run::GridFile grid({file});
  const auto arrays = grid.arrays("PointData");
  const bool with_unit =
      std::any_of(arrays.begin(), arrays.end(), [](const auto& array) { return array.name == "radius_m"; });
  if (grid.point_count() == 0) throw DiscFileError(fmt::format("{}: no points in it", file.string()));
  const char* radius_name = with_unit ? "radius_m" : "radius";
  if (std::none_of(arrays.begin(), arrays.end(),
                   [&](const auto& array) { return array.name == radius_name; }))
    throw DiscFileError(fmt::format("{}: no point array radius or radius_m", file.string()));
  const auto centres = grid.points();
  const auto radii = grid.point_array(radius_name);
  std::vector<double> discs;
  discs.reserve(3 * centres.size());
  for (std::size_t i = 0; i < centres.size(); ++i)
    discs.insert(discs.end(), {centres[i].x, centres[i].y, radii[i]});
  return discs;
}

}  // namespace

std::vector<double> read_discs(const std::filesystem::path& file) {
  return file.extension() == ".vtu" || file.extension() == ".pvtu" ? read_vtu(file) : read_csv(file);
}

std::vector<int64_t> read_bonds(const std::filesystem::path& file) {
  std::vector<int64_t> bonds;
  read_columns(file, bond_columns, 2, [&](size_t line, const auto& words) {
    if (!words[2].empty() && number_of<int64_t>(words[2], file, line, bond_columns[2]) != 0) return;
    for (size_t k = 0; k < 2; ++k) bonds.push_back(number_of<int64_t>(words[k], file, line, bond_columns[k]));
  });
  if (bonds.empty()) throw DiscFileError(fmt::format("{}: no bonds in it", file.string()));
  return bonds;
}

std::string discs_as_csv(const std::vector<double>& discs) {
  std::string text = "x_m,y_m,radius_m\n";
  for (std::size_t k = 0; k + 2 < discs.size(); k += 3)
    text += fmt::format("{},{},{}\n", discs[k], discs[k + 1], discs[k + 2]);
  return text;
}

std::string bonds_as_csv(const std::vector<int64_t>& bonds) {
  std::string text = "disc_0,disc_1\n";
  for (std::size_t k = 0; k + 1 < bonds.size(); k += 2)
    text += fmt::format("{},{}\n", bonds[k], bonds[k + 1]);
  return text;
}

}  // namespace hfrac::output
