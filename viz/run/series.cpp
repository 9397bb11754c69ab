// SPDX-License-Identifier: BSD-3-Clause
// A .pvd file is a small XML list; times are in seconds and file names relative to the list.
#include "run/series.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <utility>

#include "run/files.hpp"
#include "run/text.hpp"
#include "run/xml_tree.hpp"

namespace hfrac::run {
namespace {

/** "discs_00012.vtu" -> 12; -1 if there is no number. */
int64_t snapshot_number(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  size_t first = stem.size();
  while (first > 0 && std::isdigit(static_cast<unsigned char>(stem[first - 1])) != 0) --first;
  return number_in<int64_t>(std::string_view(stem).substr(first)).value_or(-1);
}

}  // namespace

const SeriesFile* file_of(const Series& series, int64_t number) {
  const auto found = series.find(number);
  return found != series.end() ? &found->second : nullptr;
}

Series read_series(const std::filesystem::path& folder, std::string_view name) {
  Series series;
  const auto path = folder / fmt::format("{}.pvd", name);
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return series;
  const auto root = parse_xml(read_whole(path), path);
  const XmlElement* collection = root->child("Collection");
  if (collection == nullptr) fail_reading(path.string() + " is not a ParaView collection");
  int64_t position = 0;
  for (const auto& entry : collection->children) {
    const std::string file = entry->attribute("file");
    if (file.empty()) continue;
    const double time = number_in<double>(entry->attribute("timestep")).value_or(NAN);
    const int64_t number = snapshot_number(file);
    series[number >= 0 ? number : position] = {folder / file,
                                               std::isfinite(time) ? time : static_cast<double>(position)};
    ++position;
  }
  return series;
}

SeriesWriter::SeriesWriter(std::filesystem::path folder, std::string name)
    : folder_(std::move(folder)), name_(std::move(name)) {}

void SeriesWriter::add(const SnapshotEntry& entry, const std::string& text) {
  write_whole(folder_ / file_of(entry.step), text);
  entries_.push_back(entry);
  try {
    write_list();
  } catch (...) {
    entries_.pop_back();
    throw;
  }
}

void SeriesWriter::go_on_from(const std::vector<SnapshotEntry>& entries) {
  for (const auto& entry : entries) {
    std::vector<std::string> files{file_of(entry.step)};
    for (int64_t k = 0; pieces_ > 1 && k < pieces_; ++k) files.push_back(piece_name(name_, entry.step, k));
    for (const auto& file : files) {
      if (!is_file(folder_ / file))
        fail_reading(
            fmt::format("'{}' is missing, so the run cannot go on where it was", (folder_ / file).string()));
    }
  }
  entries_ = entries;
  write_list();
}

std::string SeriesWriter::file_of(int64_t step) const {
  return fmt::format("{}_{:05}.{}", name_, step, pieces_ > 1 ? "pvtu" : "vtu");
}

std::string piece_name(std::string_view series, int64_t step, int64_t piece) {
  return fmt::format("{}_{:05}_{:04}.vtu", series, step, piece);
}

void SeriesWriter::write_list() const {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const auto& entry : entries_)
    text += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", entry.time,
                        file_of(entry.step));
  write_whole(folder_ / (name_ + ".pvd"), text + "  </Collection>\n</VTKFile>\n");
}

}  // namespace hfrac::run
