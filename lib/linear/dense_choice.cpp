// SPDX-License-Identifier: BSD-3-Clause
// Picks the dense kernels for the processor at hand; all give the same bits.
#include "core/instruction_set.hpp"
#include "linear/dense_kernels.hpp"

namespace hfrac {

HFRAC_TABLE_OF_SET(dense, DenseTable)

const DenseTable* dense_kernels_for(const char* name) noexcept {
  return of_set(name);
}

const DenseTable& dense_kernels() noexcept {
  return *of_set(widest_instruction_set());
}

}  // namespace hfrac
