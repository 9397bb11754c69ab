// SPDX-License-Identifier: BSD-3-Clause
#include "whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "core/error.hpp"

namespace hfrac::capi {
namespace {

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

void write_whole_file(const std::string& path, std::string_view bytes) {
  const auto slash = path.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
  const std::string aside = folder + "." + path.substr(folder.size()) + ".tmp";
  const int descriptor = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  bool good = descriptor >= 0;
  int reason = errno;
  if (good) {
    good = write_all(descriptor, bytes) && ::fsync(descriptor) == 0;
    if (!good) reason = errno;
    if (::close(descriptor) != 0 && good) {
      good = false;
      reason = errno;
    }
    if (good && std::rename(aside.c_str(), path.c_str()) != 0) {
      good = false;
      reason = errno;
    }
    if (!good) ::unlink(aside.c_str());
  }
  if (!good) {
    throw Error(ErrorKind::argument,
                "cannot write '" + path + "': " + std::generic_category().message(reason) + ".");
  }
}

}  // namespace hfrac::capi
