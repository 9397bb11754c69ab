// SPDX-License-Identifier: BSD-3-Clause
// Files that appear whole or not at all.
//
// A file is written under the name `.NAME.tmp` beside its place, synced to the disk and renamed, and the folder synced. A
// reader, a full disk or a power cut therefore never meets half a file: it sees the old one or the new one. A symbolic
// link that someone put under one of our names is never followed to where it leads.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hfrac::output {

/** A file could not be written; the text names the file and the system's reason. */
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/** Name under which `file` is written before it is renamed. */
std::filesystem::path aside_name(const std::filesystem::path& file);

/** Puts `bytes` into `file` as a whole, replacing what was there. */
void write_whole(const std::filesystem::path& file, std::string_view bytes);

/** Adds whole `lines` to the end of `file`. If they do not fit, none of them stays. */
void append_whole(const std::filesystem::path& file, std::string_view lines);

/** Has the disk keep what was added to `file`. */
void sync_file(const std::filesystem::path& file);

/** Makes `folder`, a single one, if it is not there. A link in its place, which would lead elsewhere, is refused. */
void make_real_folder(const std::filesystem::path& folder);

/** The whole content of `file`. */
std::string read_whole(const std::filesystem::path& file);

}  // namespace hfrac::output
