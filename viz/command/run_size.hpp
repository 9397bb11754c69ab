// SPDX-License-Identifier: BSD-3-Clause
// What a run will write and what memory it takes, told before it begins: a case that asks for a snapshot of every one of 1e12 steps is
// allowed, and no disk holds it.
//
// The numbers are estimates, good to a factor of two: how well arrays pack depends on what happens, and a run that meets a stop
// condition writes less.
#pragma once

#include <hfrac/hfrac.h>

#include <filesystem>
#include <string>

namespace hfrac::command {

struct RunSize {
  double snapshots = 0.0;
  double files = 0.0;
  double bytes = 0.0;
  double memory = 0.0;  ///< bytes of one process
};

/** Of a run of `steps` steps; -1: as the case says. */
RunSize size_of_run(const hfrac_sim_def& definition, int64_t steps);

/** "41 snapshots, about 170 files and 25 MB". */
std::string size_text(const RunSize& size);

/** "1.1 GB". */
std::string memory_text(const RunSize& size);

/** Throws BadInput if the disk of `folder`, which need not exist yet, plainly has no room for that. */
void require_room(const RunSize& size, const std::filesystem::path& folder);

}  // namespace hfrac::command
