// SPDX-License-Identifier: BSD-3-Clause
// What a picture, the page or a report begins with: the lists of the series that pictures are drawn from, and what
// summary.json says about the model. Nothing of the VTU files is read here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/engine_call.hpp"
#include "run/series.hpp"

namespace hfrac::run {

struct WellPlace {
  double x = 0;       // [m]
  double y = 0;       // [m]
  double radius = 0;  // [m] of a circle as large as the hole between disc centres
  double asked = 0;   // [m] radius of the hole that was asked for; 0: none was cut, or not known
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
  Series joints;  // empty without smooth joints
};

// Throws ReadError.
RunFolder open_run(const std::filesystem::path& folder);

// The simulation as it stands, as the one snapshot of a folder that is nowhere on the disk.
RunFolder run_in_memory(hfrac_sim* sim);

}  // namespace hfrac::run
