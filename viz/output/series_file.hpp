// SPDX-License-Identifier: BSD-3-Clause
// One ParaView series: the files NAME_00000.vtu, NAME_00010.vtu, ... and NAME.pvd that lists them with their
// times.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/checkpoint.hpp"

namespace hfrac::output {

class SeriesFile {
 public:
  SeriesFile(std::filesystem::path folder, std::string name);

  /** Writes one more member of the series, then the list. The list is replaced as a whole and never names a
   * file that is not there, so ParaView may read it while the run goes on. */
  void add(int64_t step, double time, const std::string& vtu);

  /** Goes on behind `entries`: replaces the list by theirs. Throws FileError if a file of theirs is not there. */
  void go_on_from(const std::vector<SnapshotEntry>& entries);

  size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    double time;
    std::string file;
  };
  std::string file_of(int64_t step) const;
  std::string list() const;

  std::filesystem::path folder_;
  std::string name_;
  std::vector<Entry> entries_;
};

}  // namespace hfrac::output
