// SPDX-License-Identifier: BSD-3-Clause
#include "output/disc_file.hpp"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>

namespace hfrac::output {
namespace {

constexpr std::array<std::string_view, 3> wanted{"x", "y", "radius"};

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

std::vector<double> read_csv(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw DiscFileError(fmt::format("cannot read '{}'", file.string()));
  std::vector<double> discs;
  std::array<std::size_t, 3> column{};
  bool named = false;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    const auto words = words_of(line);
    if (words.empty() || words.front().starts_with('#')) continue;
    if (!named) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at =
            std::find_if(words.begin(), words.end(), [&](auto word) { return is_name(word, wanted[k]); });
        if (at == words.end())
          throw DiscFileError(
              fmt::format("{}:{}: no column {}; the first line names the columns x, y and radius",
                          file.string(), number, wanted[k]));
        column[k] = static_cast<std::size_t>(at - words.begin());
      }
      named = true;
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      double value = 0.0;
      const auto word = column[k] < words.size() ? words[column[k]] : std::string_view{};
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (error != std::errc{} || end != word.data() + word.size())
        throw DiscFileError(fmt::format("{}:{}: {} is '{}', not a number", file.string(), number, wanted[k],
                                        word.substr(0, 40)));
      discs.push_back(value);
    }
  }
  if (discs.empty()) throw DiscFileError(fmt::format("{}: no discs in it", file.string()));
  return discs;
}

std::vector<double> read_vtu(const std::filesystem::path& file) {
  if (!std::ifstream(file)) throw DiscFileError(fmt::format("cannot read '{}'", file.string()));
  const vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  const vtkIdType count = grid != nullptr ? grid->GetNumberOfPoints() : 0;
  if (count == 0) throw DiscFileError(fmt::format("{}: no points in it", file.string()));
  vtkDataArray* radius = grid->GetPointData()->GetArray("radius_m");
  if (radius == nullptr) radius = grid->GetPointData()->GetArray("radius");
  if (radius == nullptr)
    throw DiscFileError(fmt::format("{}: no point array radius or radius_m", file.string()));
  std::vector<double> discs;
  discs.reserve(3 * static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i) {
    double at[3];
    grid->GetPoint(i, at);
    discs.insert(discs.end(), {at[0], at[1], radius->GetComponent(i, 0)});
  }
  return discs;
}

}  // namespace

std::vector<double> read_discs(const std::filesystem::path& file) {
  return file.extension() == ".vtu" ? read_vtu(file) : read_csv(file);
}

std::string discs_as_csv(const std::vector<double>& discs) {
  std::string text = "x_m,y_m,radius_m\n";
  for (std::size_t k = 0; k + 2 < discs.size(); k += 3)
    text += fmt::format("{},{},{}\n", discs[k], discs[k + 1], discs[k + 2]);
  return text;
}

}  // namespace hfrac::output
