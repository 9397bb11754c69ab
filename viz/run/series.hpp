// SPDX-License-Identifier: BSD-3-Clause
// The series of a run folder: the files NAME_00000.vtu, NAME_00010.vtu, ... and NAME.pvd, the list of them with their
// times that ParaView opens.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hfrac::run {

inline constexpr std::array<const char*, 5> series_names = {"discs", "bonds", "cracks", "flow", "joints"};

/** One VTU file of a series. */
struct SeriesFile {
  std::filesystem::path path;
  double time = 0.0;  ///< [s] as the list says
  std::shared_ptr<const std::string> content =
      nullptr;  ///< what the file would hold, if it is not on the disk
};
/** By number of the snapshot, the N of NAME_N.vtu, which is the same in all series. */
using Series = std::map<int64_t, SeriesFile>;

/** The file of snapshot `number`, or nullptr. */
const SeriesFile* file_of(const Series& series, int64_t number);

/** Reads folder/NAME.pvd; no list is an empty series. Throws ReadError if it is damaged. */
Series read_series(const std::filesystem::path& folder, std::string_view name);

/** A snapshot in the lists of a run folder. */
struct SnapshotEntry {
  int64_t step = 0;
  double time = 0.0;  ///< [s] model time
};

/** The file of a snapshot's piece, NAME_STEP_PIECE.vtu. */
std::string piece_name(std::string_view series, int64_t step, int64_t piece);

/** Writes one series while a run goes on. */
class SeriesWriter {
 public:
  SeriesWriter(std::filesystem::path folder, std::string name);

  /** From now on its members are lists of so many pieces, NAME_STEP.pvtu; 1: files of their own. */
  void in_pieces(int64_t count) { pieces_ = count; }

  /** Writes one more member of the series, then the list. The list is replaced as a whole and never names a file that is
   * not there, so ParaView may read it while the run goes on. Throws WriteError. */
  void add(const SnapshotEntry& entry, const std::string& text);

  /** Goes on behind `entries`: replaces the list by theirs. Throws FileError if a file of theirs is not there. */
  void go_on_from(const std::vector<SnapshotEntry>& entries);

 private:
  std::string file_of(int64_t step) const;
  void write_list() const;

  std::filesystem::path folder_;
  std::string name_;
  int64_t pieces_ = 1;
  std::vector<SnapshotEntry> entries_;
};

}  // namespace hfrac::run
