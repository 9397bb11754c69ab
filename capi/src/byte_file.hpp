// SPDX-License-Identifier: BSD-3-Clause
// Files of bytes that are there whole or not at all.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace hfrac::capi {

// Writes file `path`: beside it first, synced, then renamed, then the folder synced. After
// a crash or a power cut there is the old file or the new one. Throws Error(file); what it wrote beside is gone then.
void write_whole_file(const std::string& path, std::span<const std::byte> bytes);

// A file that is read, as a whole or in parts. All throw Error(file).
class SavedFile {
 public:
  // Refuses what is no regular file or is larger than `limit` bytes.
  SavedFile(std::string path, std::size_t limit);

  [[nodiscard]] std::size_t size() const { return size_; }
  // From the place `from` on, as many bytes as there is room for. Returns how many there were: fewer if it is cut meanwhile.
  std::size_t read(std::size_t from, std::span<std::byte> bytes) const;

 private:
  struct Open {
    explicit Open(const char* path);
    ~Open();
    Open(const Open&) = delete;
    Open& operator=(const Open&) = delete;
    int number;
  };
  std::string path_;
  Open file_;
  std::size_t size_ = 0;
};

// All of a file. Throws Error(file), also for what is no regular file or is larger than `limit` bytes.
std::vector<std::byte> read_whole_file(const std::string& path, std::size_t limit);

}  // namespace hfrac::capi
