// SPDX-License-Identifier: BSD-3-Clause
#include "core/instruction_set.hpp"

#include <cstring>
#include <initializer_list>

namespace hfrac {

bool has_instruction_set(const char* name) noexcept {
  if (std::strcmp(name, "baseline") == 0) return true;
#if defined(HFRAC_KERNELS_X86)
  if (std::strcmp(name, "avx2") == 0) return __builtin_cpu_supports("avx2");
  if (std::strcmp(name, "avx512") == 0) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
  }
#endif
  return false;
}

const char* widest_instruction_set() noexcept {
  for (const char* name : {"avx512", "avx2"}) {
    if (has_instruction_set(name)) return name;
  }
  return "baseline";
}

}  // namespace hfrac
