// SPDX-License-Identifier: BSD-3-Clause
// Files that appear whole or not at all.
//
// The content goes to another name in the same folder and reaches the disk before the name is changed: a
// reader sees the old file or the new one, never half of one, whatever happens in between. Whatever goes
// wrong leaves no rest.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace hfrac::viz {

// A name to write to, turned into `target` by commit(), removed otherwise.
class WholeFile {
 public:
  explicit WholeFile(std::filesystem::path target);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::filesystem::path& working_path() const { return working_; }
  const std::filesystem::path& target() const { return target_; }
  // Throws Failure(HFRAC_VIZ_ERR_WRITE).
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path working_;
  bool committed_ = false;
};

// Throws Failure(HFRAC_VIZ_ERR_WRITE) with the system's reason.
void write_whole(const std::filesystem::path& target, std::span<const std::uint8_t> content);

// Makes a folder and those above it. Throws Failure(HFRAC_VIZ_ERR_WRITE).
void make_folder(const std::filesystem::path& folder);

}  // namespace hfrac::viz
