// SPDX-License-Identifier: BSD-3-Clause
// Picks the kernels for the processor at hand. All give the same bits: multiply-add is never fused, and sums are
// taken in one order whatever the vector width.
#include <cstring>
#include <initializer_list>

#include "solid/kernels.hpp"

namespace hfrac {

namespace kernels_baseline {
extern const KernelTable table;
}
#if defined(HFRAC_KERNELS_X86)
namespace kernels_avx2 {
extern const KernelTable table;
}
namespace kernels_avx512 {
extern const KernelTable table;
}
#endif

const KernelTable* kernels_for(const char* name) noexcept {
  if (std::strcmp(name, "baseline") == 0) return &kernels_baseline::table;
#if defined(HFRAC_KERNELS_X86)
  if (std::strcmp(name, "avx2") == 0 && __builtin_cpu_supports("avx2")) return &kernels_avx2::table;
  if (std::strcmp(name, "avx512") == 0 && __builtin_cpu_supports("avx512f") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw")) {
    return &kernels_avx512::table;
  }
#endif
  return nullptr;
}

const KernelTable& kernels() noexcept {
  for (const char* name : {"avx512", "avx2"}) {
    if (const KernelTable* table = kernels_for(name)) return *table;
  }
  return kernels_baseline::table;
}

const char* kernel_isa() noexcept {
  return kernels().name;
}

}  // namespace hfrac
