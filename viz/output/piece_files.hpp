// SPDX-License-Identifier: BSD-3-Clause
// Snapshots in pieces (output.pieces): files of discs, bonds and flow that several processes write side by side, and the lists of them, PVTU
// files, that ParaView opens.
//
// How many pieces there are the case says and not the number of processes, so that a run folder is the same on any number of them. Piece k is
// that of process k modulo their number. No list is written before all of its pieces are there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "run/snapshot_grids.hpp"

namespace hfrac::output {

using run::SnapshotFrame;

/** The processes of a run. */
struct Writers {
  int64_t rank = 0, count = 1;
  /** Of a number of each; throws std::runtime_error if one is gone. Called by all of them, unless there is one alone. */
  std::function<int64_t(int64_t)> sum = nullptr;
};

class PieceFiles {
 public:
  explicit PieceFiles(std::filesystem::path folder, Writers writers = {});

  /** The texts of the lists. */
  struct Lists {
    std::string discs, bonds, flow;
  };
  /** Of the first process; the others say follow() meanwhile. Without `due` they are told that there is nothing to write. Throws FileError on all
   * if one could not write. */
  Lists write(const SnapshotFrame& frame, bool due);
  /** Writes this process's pieces of the snapshot that the first one asks for, if it does. */
  void follow(hfrac_sim* sim);
  /** From now on the others no longer follow. */
  void go_alone() { writers_ = {}; }

 private:
  bool agree(bool due) const;
  Lists write_own(const SnapshotFrame& frame) const;

  std::filesystem::path folder_;
  Writers writers_;
};

}  // namespace hfrac::output
