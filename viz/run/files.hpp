// SPDX-License-Identifier: BSD-3-Clause
// Files that appear whole or not at all.
//
// A file is written beside its place under a name of its own, `.NAME.PID-N.tmp`, synced to the disk and renamed, and the
// folder synced. A reader, a full disk or a power cut therefore never meets half a file: it sees the old one or the new
// one. No two writers share an unfinished file, a symbolic link that someone put under one of our names is never followed,
// and what a killed process leaves is known by its name (known_files.hpp).
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hfrac::run {

/** Something is wrong with a file; the text names the file and says what. */
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
/** It is missing, damaged or cannot be read. */
class ReadError : public FileError {
 public:
  using FileError::FileError;
};
/** It cannot be written. */
class WriteError : public FileError {
 public:
  using FileError::FileError;
};

[[noreturn]] void fail_reading(const std::string& text);
[[noreturn]] void fail_writing(const std::string& text);

/** An unfinished file, for libraries that write files by themselves: it becomes `target` by commit() and is removed
 * otherwise. */
class WholeFile {
 public:
  explicit WholeFile(std::filesystem::path target);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::filesystem::path& working_path() const { return working_; }
  const std::filesystem::path& target() const { return target_; }
  /** Throws WriteError with the system's reason. */
  void commit();

 private:
  std::filesystem::path target_, working_;
  bool committed_ = false;
};

/** Puts `bytes` into `file` as a whole, replacing what was there. Throws WriteError, as all that write do. */
void write_whole(const std::filesystem::path& file, std::string_view bytes);
void write_whole(const std::filesystem::path& file, std::span<const uint8_t> bytes);
/** The same of what stands in several places, one after the other. */
void write_whole(const std::filesystem::path& file, std::initializer_list<std::string_view> parts);

/** Adds whole `lines` to the end of `file`. If they do not fit, none of them stays. */
void append_whole(const std::filesystem::path& file, std::string_view lines);

/** Has the disk keep what was added to `file`. */
void sync_file(const std::filesystem::path& file);

/** Makes `folder`, a single one, if it is not there. A link in its place, which would lead elsewhere, is refused. */
void make_real_folder(const std::filesystem::path& folder);
/** Makes `folder` and those above it. */
void make_folder(const std::filesystem::path& folder);

/** Removes a file that may be missing. */
void remove_file(const std::filesystem::path& file);

bool is_file(const std::filesystem::path& file);

/** The whole content of `file`. Throws ReadError. */
std::string read_whole(const std::filesystem::path& file);
/** The same, empty if there is no such file. */
std::string read_if_there(const std::filesystem::path& file);

}  // namespace hfrac::run
