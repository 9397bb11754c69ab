// SPDX-License-Identifier: BSD-3-Clause
// summary.json: what a run was, what came out of it and why it ended, for programs and for `hfrac info`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run/snapshot_grids.hpp"

namespace hfrac::output {
using namespace hfrac::run;

/** What was asked for beside the case file; hfrac resume goes by it. */
struct RunTerms {
  int64_t steps = -1;        ///< steps to take; -1: as the case says
  std::vector<double> grid;  ///< of a reservoir simulator (host_cells.hpp); empty: none
  bool movie = false;        ///< drawn while the run goes on
};

/** What the library warned of, or the program of the case. */
struct Warning {
  int64_t step = 0;  ///< steps taken then; 0: during the initial equilibration
  std::string text;
};

/** So many warnings are kept; steps that did not come to rest are counted beside. */
inline constexpr size_t kMostWarnings = 20;

/** How the run itself went, beside what the engine knows. */
struct RunCourse {
  std::string ended = "running";  ///< "running" while it goes on, else why it ended
  double wall_seconds = 0.0;      ///< since the start of set-up
  int64_t snapshots = 0;          ///< complete ones
  int64_t steps_not_at_rest = 0;  ///< steps whose mechanics did not reach stepping.force_ratio
  std::vector<Warning> warnings;  ///< the first kMostWarnings
  RunTerms terms;
};

/** The warnings in a summary, up to step `last`; those of set-up, which is done anew, left out. */
std::vector<Warning> warnings_of(const nlohmann::ordered_json& summary, int64_t last);

/** The terms in a summary. Throws nlohmann::json::exception if there are none. */
RunTerms terms_of(const nlohmann::ordered_json& summary);

nlohmann::ordered_json make_summary(const SnapshotFrame& frame, const RunCourse& course);

}  // namespace hfrac::output
