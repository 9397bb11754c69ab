// SPDX-License-Identifier: BSD-3-Clause
// A .pvd file is a small XML list; times are in seconds and file names relative to the list.
#include "output/series_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "output/safe_file.hpp"

namespace hfrac::output {

SeriesFile::SeriesFile(std::filesystem::path folder, std::string name)
    : folder_(std::move(folder)), name_(std::move(name)) {}

void SeriesFile::add(int64_t step, double time, const std::string& vtu) {
  const std::string file = file_of(step);
  write_whole(folder_ / file, vtu);
  entries_.push_back({time, file});
  try {
    write_whole(folder_ / (name_ + ".pvd"), list());
  } catch (...) {
    entries_.pop_back();
    throw;
  }
}

void SeriesFile::go_on_from(const std::vector<SnapshotEntry>& entries) {
  entries_.clear();
  for (const auto& entry : entries) {
    const auto path = folder_ / file_of(entry.step);
    if (!std::filesystem::is_regular_file(path))
      throw FileError(fmt::format("'{}' is missing, so the run cannot go on where it was", path.string()));
    entries_.push_back({entry.time, file_of(entry.step)});
  }
  write_whole(folder_ / (name_ + ".pvd"), list());
}

std::string SeriesFile::file_of(int64_t step) const {
  return fmt::format("{}_{:05}.vtu", name_, step);
}

std::string SeriesFile::list() const {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const auto& entry : entries_)
    text += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", entry.time,
                        entry.file);
  return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace hfrac::output
