// SPDX-License-Identifier: BSD-3-Clause
// Picks the kernels for the processor at hand. All give the same bits: multiply-add is never fused, and sums are
// taken in one order whatever the vector width.
#include <cstring>

#include "core/instruction_set.hpp"
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
  if (!has_instruction_set(name)) return nullptr;
#if defined(HFRAC_KERNELS_X86)
  if (std::strcmp(name, "avx2") == 0) return &kernels_avx2::table;
  if (std::strcmp(name, "avx512") == 0) return &kernels_avx512::table;
#endif
  return &kernels_baseline::table;
}

const KernelTable& kernels() noexcept {
  return *kernels_for(widest_instruction_set());
}

const char* kernel_isa() noexcept {
  return kernels().name;
}

}  // namespace hfrac
