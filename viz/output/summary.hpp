// SPDX-License-Identifier: BSD-3-Clause
// summary.json: what a run was, what came out of it and why it ended, for programs and for `hfrac info`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "output/snapshot_grids.hpp"

namespace hfrac::output {

/** How the run itself went, beside what the engine knows. */
struct RunCourse {
  std::string ended = "running";  ///< "running" while it goes on, else why it ended
  double wall_seconds = 0.0;      ///< since the start of set-up
  int64_t snapshots = 0;          ///< complete ones
  int64_t steps_not_at_rest = 0;  ///< steps whose mechanics did not reach stepping.force_ratio
};

nlohmann::ordered_json make_summary(const SnapshotFrame& frame, const RunCourse& course);

}  // namespace hfrac::output
