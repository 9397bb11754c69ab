// SPDX-License-Identifier: BSD-3-Clause
#include "command/standard_streams.hpp"

#include <fcntl.h>
#include <stdio_ext.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace hfrac::command {

void reserve_standard_streams() {
  for (int number = 0; number <= 2; ++number) {
    if (::fcntl(number, F_GETFD) != -1 || errno != EBADF) continue;
    // Numbers are given in order, so this one gets the first that is free.
    if (::open("/dev/null", number == 0 ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

void tell_text(std::string_view text) noexcept {
  const int error = errno;
  while (!text.empty()) {
    const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) break;
    text.remove_prefix(static_cast<size_t>(written));
  }
  errno = error;
}

void flush_results() {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw std::runtime_error(fmt::format("the result cannot be written to standard output: {}",
                                       errno != 0 ? std::strerror(errno) : "part of it was lost"));
}

void drop_results() {
  __fpurge(stdout);
  std::clearerr(stdout);
}

}  // namespace hfrac::command
