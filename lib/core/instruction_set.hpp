// SPDX-License-Identifier: BSD-3-Clause
// Which of the compiled instruction sets this processor runs: "avx512", "avx2", "baseline". Found out once, never changes; the
// library does not read the environment. All give the same bits.
#pragma once

#include <cstring>

namespace hfrac {

// Whether the set of that name was compiled and this processor runs it.
bool has_instruction_set(const char* name) noexcept;

// The widest of them.
const char* widest_instruction_set() noexcept;

}  // namespace hfrac

// Inside namespace hfrac: `const Table* of_set(const char* name)` picks among the tables of functions that were compiled for each set,
// KIND_baseline::table and so on; nullptr: this processor does not run it.
#if defined(HFRAC_KERNELS_X86)
#define HFRAC_TABLE_OF_SET(KIND, Table)                                 \
  namespace KIND##_baseline {                                           \
    extern const Table table;                                           \
  }                                                                     \
  namespace KIND##_avx2 {                                               \
    extern const Table table;                                           \
  }                                                                     \
  namespace KIND##_avx512 {                                             \
    extern const Table table;                                           \
  }                                                                     \
  namespace {                                                           \
  const Table* of_set(const char* name) noexcept {                      \
    if (!has_instruction_set(name)) return nullptr;                     \
    if (std::strcmp(name, "avx2") == 0) return &KIND##_avx2::table;     \
    if (std::strcmp(name, "avx512") == 0) return &KIND##_avx512::table; \
    return &KIND##_baseline::table;                                     \
  }                                                                     \
  }
#else
#define HFRAC_TABLE_OF_SET(KIND, Table)                                   \
  namespace KIND##_baseline {                                             \
    extern const Table table;                                             \
  }                                                                       \
  namespace {                                                             \
  const Table* of_set(const char* name) noexcept {                        \
    return has_instruction_set(name) ? &KIND##_baseline::table : nullptr; \
  }                                                                       \
  }
#endif
