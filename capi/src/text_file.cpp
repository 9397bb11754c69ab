// SPDX-License-Identifier: BSD-3-Clause
#include "text_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "core/error.hpp"
#include "utf8.hpp"

namespace hfrac::capi {
namespace {

class File {
 public:
  // Without waiting: opening a pipe nobody writes to would.
  explicit File(const std::string& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {}
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

[[noreturn]] void refuse(const std::string& path, const std::string& fault) {
  throw Error(ErrorKind::case_file, printable(path, 400) + ": " + fault);
}

std::string system_text(int number) {
  return std::generic_category().message(number);
}

void check_lines(const std::string& path, const std::string& text, const TextLimits& limits) {
  std::size_t line = 1;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end - begin > limits.longest_line) {
      refuse(path, "line " + std::to_string(line) + " is longer than " + std::to_string(limits.longest_line) +
                       " bytes; this is not a " + limits.kind + ".");
    }
    begin = end + 1;
  }
}

}  // namespace

std::string read_text_file(const std::string& path, const TextLimits& limits) {
  const File file(path);
  if (file.descriptor() < 0) refuse(path, "cannot be opened: " + system_text(errno) + ".");
  struct stat status {};
  if (::fstat(file.descriptor(), &status) != 0) refuse(path, "cannot be read: " + system_text(errno) + ".");
  if (S_ISDIR(status.st_mode)) refuse(path, std::string("is a directory, not a ") + limits.kind + ".");
  if (!S_ISREG(status.st_mode)) refuse(path, std::string("is a device or pipe, not a ") + limits.kind + ".");
  const std::string too_large = "is larger than " + std::to_string(limits.largest_file >> 20U) +
                                " MiB; this is not a " + limits.kind + ".";
  if (status.st_size > static_cast<off_t>(limits.largest_file)) refuse(path, too_large);

  // Some files do not tell their size, so it is checked again while reading.
  std::string text;
  char buffer[16384];
  while (true) {
    const ssize_t count = ::read(file.descriptor(), buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse(path, "cannot be read: " + system_text(errno) + ".");
    if (count == 0) break;
    text.append(buffer, static_cast<std::size_t>(count));
    if (text.size() > limits.largest_file) refuse(path, too_large);
  }
  if (text.find('\0') != std::string::npos) refuse(path, "holds bytes 0; this is not a text file.");
  check_lines(path, text, limits);
  return text;
}

}  // namespace hfrac::capi
