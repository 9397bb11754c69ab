// SPDX-License-Identifier: BSD-3-Clause
// From a model in a folder that is opened, or taken up again, to the end of its run: what `hfrac run` and `hfrac resume` have
// in common.
#pragma once

#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <filesystem>
#include <functional>
#include <string>

#include "command/exit_code.hpp"
#include "command/progress_line.hpp"
#include "command/team.hpp"
#include "command/warnings.hpp"
#include "output/run_folder.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {

using run::Simulation;

/** Builds the model of `case_file`; no simulation if the user interrupted. Throws BadInput or EngineError. */
Simulation build_model(Definition definition, const std::string& case_file, const Team& team,
                       ProgressLine& line, Warnings& warnings);

/** Lays the grid of the terms, if there is one. Throws BadInput if nothing of the model lies in it: at the end of the run there
 * would be nothing to write. */
void lay_grid(hfrac_sim* sim, const output::RunTerms& terms);

/** Brings the folder to where `sim` is (`begin`), takes the steps, writes what there is to write, draws the movie if the
 * terms say so, and tells how it went. */
ExitCode run_to_end(hfrac_sim* sim, output::RunFolder& folder, const hfrac_sim_def& definition,
                    const output::RunTerms& terms, const Team& team, ProgressLine& line,
                    const std::function<void()>& begin);

/** What a process that follows does of all that: builds, takes up the state that the first one shares, steps, writes its pieces of snapshots
 * into `folder`. */
ExitCode follow(Definition definition, const std::filesystem::path& folder, int64_t steps, const Team& team);

/** Into a simulation that was just built, on all processes; empty: nothing. Returns whether the first one had an image. */
bool restore(hfrac_sim* sim, std::string image, const Team& team);

}  // namespace hfrac::command
