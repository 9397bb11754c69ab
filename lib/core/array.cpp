// SPDX-License-Identifier: BSD-3-Clause
#include "core/array.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#endif

namespace hfrac {

void advise_large_pages([[maybe_unused]] void* array, [[maybe_unused]] std::size_t bytes) noexcept {
#ifdef __linux__
  constexpr std::size_t worthwhile = 128U * 1024;  // a heap's arrays lie side by side and share pages
  if (bytes < worthwhile) return;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(array) % page) % page;
  const int error = errno;  // the host's
  madvise(static_cast<char*>(array) + before, (bytes - before) / page * page, MADV_HUGEPAGE);
  errno = error;
#endif
}

void return_unused_pages() noexcept {
#ifdef __GLIBC__
  // The first caller alone: where the host brought an allocator of its own, this is what makes glibc prepare its heap, which
  // it does without a lock, and a second thread would read lists that are not there yet.
  [[maybe_unused]] static const int prepared = malloc_trim(0);
  malloc_trim(0);
#endif
}

}  // namespace hfrac
