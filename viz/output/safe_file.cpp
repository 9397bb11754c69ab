// SPDX-License-Identifier: BSD-3-Clause
// Writing by system calls, because only they tell reliably that a disk is full or a folder may not be
// written.
#include "output/safe_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace hfrac::output {
namespace {

/** An open file that closes itself; close() reports, the destructor does not. */
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& file, int flags, bool follow_link = false)
      : number_(::open(file.c_str(), flags | O_CLOEXEC | (follow_link ? 0 : O_NOFOLLOW), 0666)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  bool close() {
    const int number = number_;
    number_ = -1;
    return ::close(number) == 0;
  }

 private:
  int number_;
};

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = ENOSPC;  // a file system that takes nothing and names no reason
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

[[noreturn]] void fail(const char* action, const std::filesystem::path& file, int error) {
  throw FileError(fmt::format("cannot {} '{}': {}", action, file.string(), std::strerror(error)));
}

/** The name of a new file is safe once its folder is synced. File systems that cannot do that say so; a disk that fails
 * is no such case. */
void sync_folder(const std::filesystem::path& folder) {
  const Descriptor descriptor(folder.empty() ? "." : folder / "", O_RDONLY | O_DIRECTORY);
  if (descriptor.is_open() && ::fsync(descriptor.number()) != 0 && (errno == EIO || errno == ENOSPC))
    fail("sync", folder, errno);
}

}  // namespace

std::filesystem::path aside_name(const std::filesystem::path& file) {
  return file.parent_path() / fmt::format(".{}.tmp", file.filename().string());
}

void write_whole(const std::filesystem::path& file, std::string_view bytes) {
  const auto aside = aside_name(file);
  Descriptor descriptor(aside, O_WRONLY | O_CREAT | O_TRUNC);
  if (!descriptor.is_open()) fail("write", file, errno);
  const bool written =
      write_all(descriptor.number(), bytes) && ::fsync(descriptor.number()) == 0 && descriptor.close();
  if (!written || ::rename(aside.c_str(), file.c_str()) != 0) {
    const int error = errno;
    ::unlink(aside.c_str());
    fail("write", file, error);
  }
  sync_folder(file.parent_path());
}

void append_whole(const std::filesystem::path& file, std::string_view lines) {
  Descriptor descriptor(file, O_WRONLY | O_CREAT | O_APPEND);
  if (!descriptor.is_open()) fail("add to", file, errno);
  struct stat before {};
  if (::fstat(descriptor.number(), &before) != 0) fail("add to", file, errno);
  if (!write_all(descriptor.number(), lines)) {
    const int error = errno;
    if (::ftruncate(descriptor.number(), before.st_size) != 0) fail("shorten", file, errno);
    fail("add to", file, error);
  }
  if (!descriptor.close()) fail("add to", file, errno);
}

void sync_file(const std::filesystem::path& file) {
  Descriptor descriptor(file, O_WRONLY | O_APPEND);
  if (!descriptor.is_open() || ::fsync(descriptor.number()) != 0 || !descriptor.close())
    fail("sync", file, errno);
}

void make_real_folder(const std::filesystem::path& folder) {
  if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST) fail("make folder", folder, errno);
  const Descriptor descriptor(folder, O_RDONLY | O_DIRECTORY);
  if (!descriptor.is_open()) fail("use as a folder", folder, errno);
}

std::string read_whole(const std::filesystem::path& file) {
  const Descriptor descriptor(file, O_RDONLY, true);
  if (!descriptor.is_open()) fail("read", file, errno);
  std::string content;
  for (char part[65536];;) {
    const ssize_t got = ::read(descriptor.number(), part, sizeof part);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("read", file, errno);
    if (got == 0) return content;
    content.append(part, static_cast<size_t>(got));
  }
}

}  // namespace hfrac::output
