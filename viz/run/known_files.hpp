// SPDX-License-Identifier: BSD-3-Clause
// Which files in a folder are ours: so that a new run neither mixes with an earlier one nor removes a
// stranger's file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace hfrac::run {

/** The files in `folder` that a run and its pictures consist of, half-written ones of a killed run included.
 * Empty if there is no folder. */
std::vector<std::filesystem::path> files_of_a_run(const std::filesystem::path& folder);

/** Removes them. Throws FileError if one cannot be removed. */
void remove_files_of_a_run(const std::filesystem::path& folder);

/** Removes snapshots of steps other than `kept` and what is only written at the end of a run: what a run that goes on
 * from an earlier moment will write anew. Throws FileError. */
void remove_later_files(const std::filesystem::path& folder, const std::vector<int64_t>& kept);

/** Makes sure that `folder` exists and can be written to, before hours are spent, and that no other process writes a
 * run into it meanwhile; takes it back if not kept. */
class FolderClaim {
 public:
  /** Whether a process holds a claim on `folder` now, as far as its file system knows locks. */
  static bool is_held(const std::filesystem::path& folder);

  explicit FolderClaim(const std::filesystem::path& folder);
  FolderClaim(const FolderClaim&) = delete;
  FolderClaim& operator=(const FolderClaim&) = delete;
  ~FolderClaim();
  void keep() { made_.clear(); }

 private:
  void lock(const std::filesystem::path& folder);

  int lock_ = -1;  ///< the folder, open and locked; the system frees it if we are killed
  std::vector<std::filesystem::path> made_;  ///< folders that did not exist before, the innermost first
};

}  // namespace hfrac::run
