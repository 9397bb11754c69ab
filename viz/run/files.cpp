// SPDX-License-Identifier: BSD-3-Clause
// Writing by system calls, because only they tell reliably that a disk is full or a folder may not be
// written.
#include "run/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace hfrac::run {
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

std::string cannot(const char* action, const std::filesystem::path& file, int error) {
  return fmt::format("cannot {} '{}': {}", action, file.string(), std::generic_category().message(error));
}

[[noreturn]] void fail(const char* action, const std::filesystem::path& file, int error) {
  fail_writing(cannot(action, file, error));
}

/** The name of a new file is safe once its folder is synced. File systems that cannot do that say so; a disk that fails
 * is no such case. */
void sync_folder(const std::filesystem::path& folder) {
  const Descriptor descriptor(folder.empty() ? "." : folder / "", O_RDONLY | O_DIRECTORY);
  if (descriptor.is_open() && ::fsync(descriptor.number()) != 0 && (errno == EIO || errno == ENOSPC))
    fail("sync", folder, errno);
}

}  // namespace

void fail_reading(const std::string& text) {
  throw ReadError(text);
}

void fail_writing(const std::string& text) {
  throw WriteError(text);
}

WholeFile::WholeFile(std::filesystem::path target) : target_(std::move(target)) {
  static std::atomic<unsigned> serial{0};
  working_ =
      target_.parent_path() / fmt::format(".{}.{}-{}.tmp", target_.filename().string(), ::getpid(), ++serial);
}

WholeFile::~WholeFile() {
  if (!committed_) ::unlink(working_.c_str());
}

void WholeFile::commit() {
  {
    const Descriptor file(working_, O_RDONLY);
    if (!file.is_open() || ::fsync(file.number()) != 0) fail("write", target_, errno);
  }
  if (::rename(working_.c_str(), target_.c_str()) != 0) fail("write", target_, errno);
  committed_ = true;
  sync_folder(target_.parent_path());
}

void write_whole(const std::filesystem::path& file, std::initializer_list<std::string_view> parts) {
  WholeFile whole(file);
  Descriptor descriptor(whole.working_path(), O_WRONLY | O_CREAT | O_EXCL);
  bool good = descriptor.is_open();
  for (const auto part : parts) good = good && write_all(descriptor.number(), part);
  if (!good || !descriptor.close()) fail("write", file, errno);
  whole.commit();
}

void write_whole(const std::filesystem::path& file, std::string_view bytes) {
  write_whole(file, {bytes});
}

void write_whole(const std::filesystem::path& file, std::span<const uint8_t> bytes) {
  write_whole(file, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
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

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail("make folder", folder, error.value());
}

void remove_file(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::remove(file, error);
  if (error) fail("remove", file, error.value());
}

bool is_file(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored);
}

std::string read_whole(const std::filesystem::path& file) {
  const Descriptor descriptor(file, O_RDONLY, true);
  if (!descriptor.is_open()) fail_reading(cannot("read", file, errno));
  std::string content;
  struct stat there {};
  if (::fstat(descriptor.number(), &there) == 0 && there.st_size > 0)
    content.reserve(static_cast<size_t>(there.st_size));
  for (char part[65536];;) {
    const ssize_t got = ::read(descriptor.number(), part, sizeof part);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_reading(cannot("read", file, errno));
    if (got == 0) return content;
    content.append(part, static_cast<size_t>(got));
  }
}

std::string read_if_there(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored) ? read_whole(file) : std::string();
}

}  // namespace hfrac::run
