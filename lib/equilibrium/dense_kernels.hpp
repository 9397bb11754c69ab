// SPDX-License-Identifier: BSD-3-Clause
// Dense pieces of a sparse factor (multifrontal.hpp), compiled for several instruction sets from one source.
//
// Matrices are stored by columns, `ld` apart. Every entry is changed by the same operations in the same order whatever the
// vector width, and multiply-add is never fused, so all instruction sets give the same bits. Like solid/kernels.hpp, no
// standard templates are included here.
#pragma once

#include <stdint.h>  // NOLINT(modernize-deprecated-headers): see above

namespace hfrac {

struct DenseKernels {
  // L U of the first p columns and rows of the m x m front W, by blocks; the rest becomes its Schur complement. Rows are
  // exchanged among the first p only, and only where the diagonal is ten times smaller than what is below it: row k with
  // row swaps[k].
  void (*factor_front)(double* w, int64_t m, int64_t p, int64_t ld, int32_t* swaps);
  // With the factor's columns (m x p, unit lower part and U) and its rows right of them (p x (m - p)):
  // forward: pivots := L^-1 pivots, boundary -= L21 pivots; backward: pivots := U^-1 (pivots - U12 boundary).
  void (*forward)(const double* columns, int64_t m, int64_t p, const int32_t* swaps, double* pivots,
                  double* boundary);
  void (*backward)(const double* columns, const double* rows, int64_t m, int64_t p, double* pivots,
                   const double* boundary);
};

const DenseKernels& dense_kernels() noexcept;
// For tests: by name ("baseline", "avx2", "avx512"), or nullptr.
const DenseKernels* dense_kernels_for(const char* name) noexcept;

}  // namespace hfrac
