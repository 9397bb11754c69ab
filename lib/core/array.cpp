// SPDX-License-Identifier: BSD-3-Clause
#include "core/array.hpp"

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#endif

namespace hfrac {

void advise_large_pages([[maybe_unused]] void* array, [[maybe_unused]] std::size_t bytes) noexcept {
#ifdef __linux__
  constexpr std::size_t worthwhile = std::size_t{4} << 20;
  if (bytes < worthwhile) return;
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto begin = (reinterpret_cast<std::uintptr_t>(array) + page - 1) / page * page,
             end = (reinterpret_cast<std::uintptr_t>(array) + bytes) / page * page;
  const int error = errno;  // the host's
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  errno = error;
#endif
}

}  // namespace hfrac
