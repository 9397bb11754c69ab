// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints: what `hfrac resume` goes on from. A checkpoint is the engine's state image together with how far the files
// of the run folder were at that moment, in one file, so that the two can never be of different moments.
//
//   DIR/checkpoints/step_NNNNN.checkpoint    the last two; the older one is there in case the newer one is damaged
//
// A file is: magic, format, byte order, lengths, checksum (CRC-32 of what follows), the course of the run as JSON, the image.
// Written aside, synced, renamed, and the folder synced: after a kill or a power cut each is whole or not there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "run/series.hpp"

namespace hfrac::output {

using run::SnapshotEntry;

struct Checkpoint {
  int64_t step = 0;                      ///< steps taken; history.csv goes that far at least
  std::vector<SnapshotEntry> snapshots;  ///< written so far
  int64_t steps_not_at_rest = 0;
  double wall_seconds = 0.0;  ///< [s] the run has taken so far, pauses between left out
  std::string image;          ///< of hfrac_state_save
};

/** Bytes that are no whole checkpoint; the text says what is wrong with them. */
class CheckpointError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::string pack_checkpoint(const Checkpoint& checkpoint);
/** Throws CheckpointError. */
Checkpoint unpack_checkpoint(std::string bytes);

/** The folder `checkpoints` of a run folder. */
class CheckpointFolder {
 public:
  explicit CheckpointFolder(const std::filesystem::path& run_folder);

  /** Steps of the checkpoints there, the newest first, whole or not. */
  std::vector<int64_t> steps() const;

  /** Writes one and removes all but the last two. Throws FileError; those before it are then as they were. */
  void write(const Checkpoint& checkpoint) const;

  /** The newest that is whole; nothing if there is none. `damaged` gets a sentence for each newer one that is not. */
  std::optional<Checkpoint> newest(std::vector<std::string>& damaged) const;

  /** Removes those after `step`: they are of a course that is gone. */
  void remove_after(int64_t step) const;

 private:
  std::filesystem::path file(int64_t step) const;

  std::filesystem::path folder_;
};

}  // namespace hfrac::output
