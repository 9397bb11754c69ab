// SPDX-License-Identifier: BSD-3-Clause
// Bytes as a VTU file for the server of the page: refused with a sentence, or read.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "web/server/grid.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const int file = ::memfd_create("grid.vtu", MFD_CLOEXEC);
  if (file < 0 || ::write(file, data, size) != static_cast<::ssize_t>(size)) std::abort();
  try {
    const auto grid = hfrac::web::read_grid("/proc/self/fd/" + std::to_string(file));
    hfrac::web::grid_message(*grid);
    if (grid->points > 0) hfrac::web::values_of(*grid, "points", 0);
  } catch (const hfrac::web::GridError& error) {
    if (error.what()[0] == '\0') std::abort();
  }
  ::close(file);
  return 0;
}
