// SPDX-License-Identifier: BSD-3-Clause
// One ParaView series: the files NAME_00000.vtu, NAME_00010.vtu, ... and NAME.pvd that lists them with their
// times.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hfrac::output {

class SeriesFile {
 public:
  SeriesFile(std::filesystem::path folder, std::string name);

  /** Writes one more member of the series, then the list. The list is replaced as a whole and never names a
   * file that is not there, so ParaView may read it while the run goes on. */
  void add(int64_t step, double time, const std::string& vtu);

  size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    double time;
    std::string file;
  };
  std::string list() const;

  std::filesystem::path folder_;
  std::string name_;
  std::vector<Entry> entries_;
};

}  // namespace hfrac::output
