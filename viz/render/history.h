// SPDX-License-Identifier: BSD-3-Clause
// The run as a whole: what was when, read from the small crack files before anything is drawn.
#pragma once

#include <vector>

#include "run/run_folder.hpp"
#include "snapshot.h"

namespace hfrac::viz {

struct HistoryPoint {
  std::int64_t number = 0;  // of the snapshot
  Moment moment;
  int tensile_cracks = 0;
  int shear_cracks = 0;

  int cracks() const { return tensile_cracks + shear_cracks; }
};

// One point per snapshot of the discs, in order.
std::vector<HistoryPoint> read_history(const RunFolder& run);

// Adds the points of the snapshots that came after the last one of `history`.
void extend_history(const RunFolder& run, std::vector<HistoryPoint>& history);

// The point of one snapshot, -1: of the last. Throws Failure if there is none of that number.
HistoryPoint history_point(const RunFolder& run, std::int64_t number);

// Up to five snapshots (indices into the history) that show how the cracks grew: evenly over the run, as in
// the paper; if the first of them would show no crack, or the cracks stand still in two of them, evenly over
// the growth of the cracks instead.
std::vector<int> growth_stages(const std::vector<HistoryPoint>& history);

}  // namespace hfrac::viz
