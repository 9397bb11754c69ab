// SPDX-License-Identifier: BSD-3-Clause
// A run folder made up for tests: discs on a lattice with a hole, a straight crack growing out of it on both
// sides. Everything in it is known in closed form, so a test can say which pixel must have which colour.
#pragma once

#include <filesystem>
#include <string>

namespace hfrac::viz_test {

struct SyntheticRun {
  int columns = 24;      // discs along x; rows follow from the height
  double width = 12.0;   // [m]
  double height = 12.0;  // [m]
  int snapshots = 3;
  double well_radius = 1.1;  // [m]
  double half_length = 4.0;  // [m] of the crack at the end, from the well's centre
  std::string title = "Synthetic run: a crack from a hole";
  bool with_flow = true;
  bool with_tables = true;  // history.csv and cracks.csv
  bool with_temperature = false;
  bool with_joints = false;

  double spacing() const { return width / columns; }
  double well_x() const { return width / 2; }
  double well_y() const { return height / 2; }
  // [m] of the crack at a snapshot
  double half_length_at(int snapshot) const;
  // [K] hot rock, cold at the well
  double temperature_at(double x, double y) const;
};

void write_run(const std::filesystem::path& folder, const SyntheticRun& run);

// Its text files, part of write_run.
void write_tables(const std::filesystem::path& folder, const SyntheticRun& run);

// A folder that is removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace hfrac::viz_test
