// SPDX-License-Identifier: BSD-3-Clause
// A run folder: everything about one run, readable at any moment while the run goes on and after it was
// killed.
//
//   case.toml        the definition with every option filled in; `hfrac run` on it gives the same run
//   discs, bonds, cracks, flow, fractures, joints (of smooth ones, if any): one NAME_STEP.vtu per snapshot and NAME.pvd, the series for ParaView;
//                    discs, bonds and flow in pieces if the case says so (piece_files.hpp)
//   history.csv      one line per step          cracks.csv      the crack log at the last snapshot
//   slips.csv        what smooth joints slipped until then, if they did
//   fractures.csv    the fractures at the end   events.csv      seismic events of the whole run
//   fracture_lines.csv  each of these fractures as a line from tip to tip
//   summary.json     everything in short
//   checkpoints      what hfrac resume goes on from (checkpoint.hpp)
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "output/checkpoint.hpp"
#include "output/piece_files.hpp"
#include "output/summary.hpp"
#include "run/series.hpp"

namespace hfrac::output {

class RunFolder {
 public:
  /** Starts the clock; touches nothing. Of several processes the first has the folder, the others help by PieceFiles::follow: at the start, with
   * every snapshot, and when the run finishes. */
  explicit RunFolder(std::filesystem::path folder, RunTerms terms = {}, Writers writers = {});

  /** Writes the case, the head of the history and the snapshot at the start. */
  void open(hfrac_sim* sim);

  /** Instead of open(): goes on from a checkpoint that `sim` was restored from. What is in the folder of later steps is
   * taken away. Throws FileError, also if something of an earlier step is not there. */
  void go_on_from(hfrac_sim* sim, const Checkpoint& checkpoint);

  /** Writes a checkpoint of now; call it after whole steps only. Throws FileError or EngineError. */
  void checkpoint(hfrac_sim* sim);

  /** Notes a warning for the summary. */
  void add_warning(int64_t step, std::string text);

  /** Adds the line of the step just taken to the history. */
  void record_step(hfrac_sim* sim);

  /** Writes a snapshot of now, unless there is one of this step already. */
  void snapshot(hfrac_sim* sim);

  /** The last snapshot, the fractures and the summary with why the run ended. */
  void finish(hfrac_sim* sim, const std::string& why_ended);

  /** The engine failed: writes the state it still has, that before the step, and why. Never throws. */
  void finish_failed(hfrac_sim* sim, const std::string& why) noexcept;

  /** A file could not be written: notes why in the summary, if that can be written and the run had begun. Never throws. */
  void note_failure(hfrac_sim* sim, const std::string& why) noexcept;

  int64_t snapshots() const { return course_.snapshots; }
  const std::filesystem::path& path() const { return folder_; }

 private:
  void write_series(const SnapshotFrame& frame);
  void take_pieces(hfrac_sim* sim);
  void write_logs(const SnapshotFrame& frame);
  void write_summary(const SnapshotFrame& frame);
  double wall_seconds() const;
  void cut_history(int64_t step) const;

  std::filesystem::path folder_;
  std::chrono::steady_clock::time_point start_;
  PieceFiles pieces_;
  SeriesWriter discs_, bonds_, cracks_, flow_, fractures_, joints_;
  RunCourse course_;
  std::vector<SnapshotEntry> snapshots_;
  double earlier_seconds_ = 0.0;  ///< [s] wall time before this process took over
  int64_t last_checkpoint_step_ = -1;
  bool begun_ =
      false;  ///< all that the start consists of is there; before, no summary may say there is a run
};

}  // namespace hfrac::output
