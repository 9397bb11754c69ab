// SPDX-License-Identifier: BSD-3-Clause
#include "whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>

#include "failure.h"

namespace hfrac::viz {
namespace {

std::string reason(int error_number) {
  return std::generic_category().message(error_number);
}

std::string cannot_write(const std::filesystem::path& path, int error_number) {
  return "cannot write " + path.string() + ": " + reason(error_number);
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  bool open() const { return number_ >= 0; }
  int number() const { return number_; }
  int close() {
    const int result = number_ >= 0 ? ::close(number_) : 0;
    number_ = -1;
    return result;
  }

 private:
  int number_;
};

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

}  // namespace

WholeFile::WholeFile(std::filesystem::path target) : target_(std::move(target)) {
  static std::atomic<unsigned> serial{0};
  std::string name = ".";
  name.append(target_.filename().string()).append(".").append(std::to_string(::getpid()));
  name.append("-").append(std::to_string(++serial)).append(".part");
  working_ = folder_of(target_) / name;
}

WholeFile::~WholeFile() {
  if (!committed_) ::unlink(working_.c_str());
}

void WholeFile::commit() {
  {
    Descriptor file(::open(working_.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.open() || ::fsync(file.number()) != 0) fail_writing(cannot_write(target_, errno));
  }
  if (::rename(working_.c_str(), target_.c_str()) != 0) fail_writing(cannot_write(target_, errno));
  committed_ = true;
  // The new name itself must reach the disk too; file systems that cannot sync a folder keep their own order, a disk that
  // fails is no such case.
  const Descriptor folder(::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.open() && ::fsync(folder.number()) != 0 && (errno == EIO || errno == ENOSPC))
    fail_writing(cannot_write(target_, errno));
}

void write_whole(const std::filesystem::path& target, std::span<const std::uint8_t> content) {
  WholeFile whole(target);
  Descriptor file(::open(whole.working_path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!file.open()) fail_writing(cannot_write(target, errno));
  while (!content.empty()) {
    const ssize_t written = ::write(file.number(), content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail_writing(cannot_write(target, written < 0 ? errno : ENOSPC));
    content = content.subspan(static_cast<std::size_t>(written));
  }
  if (file.close() != 0) fail_writing(cannot_write(target, errno));
  whole.commit();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail_writing("cannot make the folder " + folder.string() + ": " + error.message());
}

}  // namespace hfrac::viz
