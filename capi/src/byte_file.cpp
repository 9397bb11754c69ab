// SPDX-License-Identifier: BSD-3-Clause
// By system calls, because only they tell reliably that a disk is full, and only they can sync.
#include "byte_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "core/error.hpp"

namespace hfrac::capi {
namespace {

class Descriptor {
 public:
  Descriptor(const char* path, int flags) : number_(::open(path, flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }
  // Some file systems report only here that there was no room.
  bool close() {
    const int number = number_;
    number_ = -1;
    return ::close(number) == 0;
  }

 private:
  int number_;
};

[[noreturn]] void refuse(const char* verb, const std::string& path, int error, const char* fix) {
  throw Error(ErrorKind::file, "'" + path + "' cannot be " + verb + ": " +
                                   std::generic_category().message(error) + "; " + fix);
}

bool write_all(int file, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ::ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

void write_whole_file(const std::string& path, std::span<const std::byte> bytes) {
  constexpr const char* fix = "see that its folder exists, may be written to and has room.";
  const std::string aside = path + ".part";
  {
    Descriptor file(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
    if (!file.is_open()) refuse("written", path, errno, fix);
    const bool written = write_all(file.number(), bytes) && ::fsync(file.number()) == 0 && file.close();
    if (!written || ::rename(aside.c_str(), path.c_str()) != 0) {
      const int error = errno;
      ::unlink(aside.c_str());
      refuse("written", path, error, fix);
    }
  }
  // The name is safe once its folder is synced. File systems that cannot sync a folder refuse; a disk that fails is no such
  // case, though the file is there.
  const Descriptor folder(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY);
  if (folder.is_open() && ::fsync(folder.number()) != 0 && (errno == EIO || errno == ENOSPC))
    refuse("written", path, errno, fix);
}

SavedFile::Open::Open(const char* path) : number(::open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}

SavedFile::Open::~Open() {
  if (number >= 0) ::close(number);
}

SavedFile::SavedFile(std::string path, std::size_t limit) : path_(std::move(path)), file_(path_.c_str()) {
  if (file_.number < 0) refuse("read", path_, errno, "give the path of a file that was saved before.");
  struct stat status {};
  if (::fstat(file_.number, &status) != 0 || !S_ISREG(status.st_mode))
    throw Error(ErrorKind::file, "'" + path_ + "' is not a regular file; give the path of a saved one.");
  size_ = static_cast<std::size_t>(status.st_size);
  if (size_ > limit) {
    throw Error(ErrorKind::file,
                "'" + path_ + "' has " + std::to_string(size_) +
                    " bytes, more than any state of this model; give the path of a saved one.");
  }
}

std::size_t SavedFile::read(std::size_t from, std::span<std::byte> bytes) const {
  std::size_t at = 0;
  while (at < bytes.size()) {
    const ::ssize_t got =
        ::pread(file_.number, bytes.data() + at, bytes.size() - at, static_cast<::off_t>(from + at));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse("read", path_, errno, "see that the disk is sound.");
    if (got == 0) break;
    at += static_cast<std::size_t>(got);
  }
  return at;
}

std::vector<std::byte> read_whole_file(const std::string& path, std::size_t limit) {
  const SavedFile file(path, limit);
  std::vector<std::byte> bytes(file.size());
  bytes.resize(file.read(0, bytes));
  return bytes;
}

}  // namespace hfrac::capi
