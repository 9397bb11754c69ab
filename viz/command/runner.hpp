// SPDX-License-Identifier: BSD-3-Clause
// A run from case file to finished folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "command/exit_code.hpp"

namespace hfrac::command {

/** What the user asked for. */
struct RunRequest {
  std::string case_file;
  std::filesystem::path folder;
  std::filesystem::path disc_file;  ///< the user's own discs; empty: packed as the case says
  std::filesystem::path bond_file;  ///< which of those discs are bonded; empty: all that are near
  std::vector<double> grid;         ///< of a reservoir simulator (output/host_cells.hpp); empty: none
  int64_t steps = -1;               ///< steps to take; -1: as the case says
  int64_t workers = 0;              ///< 0: as the case says
  double checkpoint_every = -1.0;   ///< [s] of wall time; -1: as the case says
  int64_t checkpoint_steps = -1;    ///< -1: as the case says
  bool overwrite = false;
  bool quiet = false;
  bool movie = false;  ///< draw it while the run goes on
  bool no_space_check = false;
};

/** Runs it. Failures that leave something readable are told here; others are thrown. */
ExitCode carry_out(const RunRequest& request);

/** The short table of a run's result; if it is complete, also what is in the folder and what to do with it. */
void print_result(const std::filesystem::path& folder, bool complete);

}  // namespace hfrac::command
