// SPDX-License-Identifier: BSD-3-Clause
#include "failing_memory.hpp"

#include <atomic>
#include <cerrno>
#include <cstddef>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
}

namespace failing_memory {
namespace {

std::atomic<long> left{-1};  // good requests to come; -1: nothing is refused
std::atomic<bool> for_good{false}, refused{false};
std::atomic<long> blocks{0};

bool refuse() {
  if (left.load(std::memory_order_relaxed) < 0 && !(for_good && refused)) return false;
  if (for_good && refused) return true;
  if (left.fetch_sub(1) != 0) return false;
  refused = true;
  return true;
}

template <class Take>
void* take(Take&& from) {
  if (refuse()) {
    errno = ENOMEM;
    return nullptr;
  }
  void* block = from();
  if (block != nullptr) ++blocks;
  return block;
}

}  // namespace

void refuse_after(long good, bool lasting) {
  refused = false;
  for_good = lasting;
  left = good;
}

bool stop_refusing() {
  left = -1;
  for_good = false;
  return refused.exchange(false);
}

long outstanding() {
  return blocks;
}

}  // namespace failing_memory

using failing_memory::take;

extern "C" {
void* malloc(std::size_t size) {
  return take([&] { return __libc_malloc(size); });
}
void* calloc(std::size_t count, std::size_t size) {
  return take([&] { return __libc_calloc(count, size); });
}
void* realloc(void* old, std::size_t size) {
  if (old == nullptr) return malloc(size);
  if (failing_memory::refuse()) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  return take([&] { return __libc_memalign(alignment, size); });
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  *block = memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}
void free(void* block) {
  if (block != nullptr) --failing_memory::blocks;
  __libc_free(block);
}
}
