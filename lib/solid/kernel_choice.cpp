// SPDX-License-Identifier: BSD-3-Clause
// Picks the kernels for the processor at hand. All give the same bits: multiply-add is never fused, and sums are
// taken in one order whatever the vector width.
#include "core/instruction_set.hpp"
#include "solid/kernels.hpp"

namespace hfrac {

HFRAC_TABLE_OF_SET(kernels, KernelTable)

const KernelTable* kernels_for(const char* name) noexcept {
  return of_set(name);
}

const KernelTable& kernels() noexcept {
  return *of_set(widest_instruction_set());
}

const char* kernel_isa() noexcept {
  return kernels().name;
}

}  // namespace hfrac
