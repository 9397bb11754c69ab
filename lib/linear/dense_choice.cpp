// SPDX-License-Identifier: BSD-3-Clause
// Picks the dense kernels for the processor at hand; all give the same bits.
#include <cstring>

#include "core/instruction_set.hpp"
#include "linear/dense_kernels.hpp"

namespace hfrac {

namespace dense_baseline {
extern const DenseTable table;
}
#if defined(HFRAC_KERNELS_X86)
namespace dense_avx2 {
extern const DenseTable table;
}
namespace dense_avx512 {
extern const DenseTable table;
}
#endif

const DenseTable* dense_kernels_for(const char* name) noexcept {
  if (!has_instruction_set(name)) return nullptr;
#if defined(HFRAC_KERNELS_X86)
  if (std::strcmp(name, "avx2") == 0) return &dense_avx2::table;
  if (std::strcmp(name, "avx512") == 0) return &dense_avx512::table;
#endif
  return &dense_baseline::table;
}

const DenseTable& dense_kernels() noexcept {
  return *dense_kernels_for(widest_instruction_set());
}

}  // namespace hfrac
