// SPDX-License-Identifier: BSD-3-Clause
// Where pictures of a run are drawn: in the run folder, which keeps them for the next time, or, if that may not be written to,
// in a folder for the time being that shows the run's files by links.
#pragma once

#include <filesystem>

namespace hfrac::command {

class DrawingFolder {
 public:
  /** Throws std::filesystem::filesystem_error if no such folder can be made. */
  explicit DrawingFolder(const std::filesystem::path& run);
  DrawingFolder(const DrawingFolder&) = delete;
  DrawingFolder& operator=(const DrawingFolder&) = delete;
  ~DrawingFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool own_ = false;  ///< made here, removed at the end
};

}  // namespace hfrac::command
