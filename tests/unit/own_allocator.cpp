// SPDX-License-Identifier: BSD-3-Clause
// A host that brings an allocator of its own, as jemalloc's users do: glibc's heap is then prepared by the first call that
// asks for it, and two threads that create simulations may be the first together. Without care one process in ten dies here,
// so that two hundred are tried; a program of its own, since the allocator is the whole process's.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <thread>

#include "core/array.hpp"

namespace {

constexpr std::size_t header = 16;
alignas(header) char room[4U << 20U];
std::atomic<std::size_t> used{0};

}  // namespace

// Gives what was never given before, and takes nothing back.
extern "C" {
void* malloc(std::size_t bytes) {
  const std::size_t at = used.fetch_add((bytes + 2 * header - 1) / header * header);
  if (at + header + bytes > sizeof room) return nullptr;
  std::memcpy(room + at, &bytes, sizeof bytes);
  return room + at + header;
}
void free(void* /*block*/) {}
void* calloc(std::size_t n, std::size_t bytes) {
  return malloc(n * bytes);
}
void* realloc(void* old, std::size_t bytes) {
  void* const block = malloc(bytes);
  if (old == nullptr || block == nullptr) return block;
  std::size_t before = 0;
  std::memcpy(&before, static_cast<char*>(old) - header, sizeof before);
  std::memcpy(block, old, before < bytes ? before : bytes);
  return block;
}
}

namespace {

void two_threads_at_once() {
  std::atomic<int> here{0};
  const auto trim = [&here] {
    ++here;
    while (here < 2) {
    }
    hfrac::return_unused_pages();
  };
  std::thread other(trim);
  trim();
  other.join();
}

}  // namespace

int main(int arguments, char** argument) {
  if (arguments > 1) {
    two_threads_at_once();
    return 0;
  }
  char once[] = "once";
  char* const again[] = {argument[0], once, nullptr};
  for (int time = 1; time <= 200; ++time) {
    pid_t child = 0;
    int status = -1;
    if (posix_spawn(&child, argument[0], nullptr, nullptr, again, environ) != 0) return 2;
    if (waitpid(child, &status, 0) != child || status != 0) {
      std::fprintf(stderr, "process %d ended with status %d\n", time, status);
      return 1;
    }
  }
}
