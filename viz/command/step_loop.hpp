// SPDX-License-Identifier: BSD-3-Clause
// The loop of a run: step, note, now and then a snapshot, until something says stop.
#pragma once

#include <hfrac/hfrac.h>

#include <string>

#include "command/progress_line.hpp"
#include "output/run_folder.hpp"

namespace hfrac::command {

/** Why a run ended. */
struct EndOfRun {
  std::string text;  ///< for the summary
  bool interrupted = false;
};

/** Writes a checkpoint. If that fails, the run goes on: it says so and nothing else is lost. */
void save_checkpoint(hfrac_sim* sim, output::RunFolder& folder, ProgressLine& line);

/** Steps `sim` to the end of the run and writes into `folder` on the way, checkpoints as
 * the definition says included. `steps` >= 0 replaces the case's
 * length. */
EndOfRun take_steps(hfrac_sim* sim, output::RunFolder& folder, const hfrac_sim_def& definition, int64_t steps,
                    ProgressLine& line);

}  // namespace hfrac::command
