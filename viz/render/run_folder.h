// SPDX-License-Identifier: BSD-3-Clause
// What a run folder holds: the lists of files of its four series, and what summary.json says about the model.
// Nothing of the VTU files is read here.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hfrac::viz {

// One VTU file of a series, from its .pvd.
struct SeriesFile {
  std::filesystem::path path;
  double time = 0;  // [s]
};
// By number of the snapshot, the N of <kind>_N.vtu, which is the same in all series.
using Series = std::map<int, SeriesFile>;

struct WellPlace {
  double x = 0;       // [m]
  double y = 0;       // [m]
  double radius = 0;  // [m]
};

struct RunFolder {
  std::filesystem::path path;
  std::string title;           // empty if unknown
  bool net_pressures = false;  // stress.convention effective: pressures are above the formation's
  double model_width = 0;      // [m], 0 if unknown
  double model_height = 0;     // [m], 0 if unknown
  std::vector<WellPlace> wells;
  bool going_on = false;      // the run is not over yet
  double planned_time = 0;    // [s] at its end, 0 if unknown
  int planned_snapshots = 0;  // at its end, 0 if unknown
  Series discs;               // never empty
  Series bonds;
  Series cracks;
  Series flow;
};

// Throws Failure(HFRAC_VIZ_ERR_READ).
RunFolder open_run(const std::filesystem::path& folder);

}  // namespace hfrac::viz
