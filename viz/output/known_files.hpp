// SPDX-License-Identifier: BSD-3-Clause
// Which files in a folder are ours: so that a new run neither mixes with an earlier one nor removes a
// stranger's file.
#pragma once

#include <filesystem>
#include <vector>

namespace hfrac::output {

/** The files in `folder` that a run and its pictures consist of, half-written ones of a killed run included.
 * Empty if there is no folder. */
std::vector<std::filesystem::path> files_of_a_run(const std::filesystem::path& folder);

/** Removes them. Throws FileError if one cannot be removed. */
void remove_files_of_a_run(const std::filesystem::path& folder);

/** Makes sure that `folder` exists and can be written to, before hours are spent; takes it back if not kept.
 */
class FolderClaim {
 public:
  explicit FolderClaim(const std::filesystem::path& folder);
  FolderClaim(const FolderClaim&) = delete;
  FolderClaim& operator=(const FolderClaim&) = delete;
  ~FolderClaim();
  void keep() { made_.clear(); }

 private:
  std::vector<std::filesystem::path> made_;  ///< folders that did not exist before, the innermost first
};

}  // namespace hfrac::output
