// SPDX-License-Identifier: BSD-3-Clause
// Dense pieces of a sparse factor (multifrontal.hpp), compiled for several instruction sets from one source, in single and
// in double precision.
//
// Matrices are stored by columns, `ld` apart. Every entry is changed by the same operations in the same order whatever the
// vector width and however columns and rows are shared out among workers, and multiply-add is never fused: all instruction
// sets and all numbers of workers give the same bits. Rows are taken in whole vectors of 16 bytes, so that up to dense_slack
// of them behind the last one are touched too: ld >= m + dense_slack in a front, whose rows behind the last one are zero, and as
// much room behind a factor's columns and rows, and behind pivots and boundary. Like solid/kernels.hpp, no standard templates are included here.
#pragma once

#include <stdint.h>  // NOLINT(modernize-deprecated-headers): see above

namespace hfrac {

constexpr int64_t dense_panel = 32;  // columns factored before the rest is updated
constexpr int64_t dense_slack = 3;

template <class Real>
struct DenseKernels {
  // L U of the first p columns and rows of the m x m front W, by panels; the rest becomes its Schur complement. Rows are
  // exchanged among the first p only, and only where the diagonal is ten times smaller than what is below it: row k with
  // row swaps[k].
  void (*factor_front)(Real* w, int64_t m, int64_t p, int64_t ld, int32_t* swaps);
  // The same in pieces: columns [begin, end) of a panel; then what they do to columns [first, last) right of them.
  void (*factor_panel)(Real* w, int64_t m, int64_t p, int64_t ld, int64_t begin, int64_t end, int32_t* swaps);
  void (*update)(Real* w, int64_t m, int64_t ld, int64_t begin, int64_t end, int64_t first, int64_t last);
  // With the factor's columns (m x p, unit lower part and U) and its rows right of them (p x (m - p)), in this order:
  // pivots := L^-1 pivots; boundary[first, last) -= L21 pivots; and back
  // pivots[first, last) -= U12 boundary; pivots := U^-1 pivots.
  void (*forward)(const Real* columns, int64_t m, int64_t p, const int32_t* swaps, Real* pivots);
  void (*below)(const Real* columns, int64_t m, int64_t p, const Real* pivots, Real* boundary, int64_t first,
                int64_t last);
  void (*right)(const Real* rows, int64_t p, int64_t b, const Real* boundary, Real* pivots, int64_t first,
                int64_t last);
  void (*backward)(const Real* columns, int64_t m, int64_t p, Real* pivots);
};

struct DenseTable {
  DenseKernels<float> single_precision;
  DenseKernels<double> double_precision;
};

const DenseTable& dense_kernels() noexcept;
// For tests: by name ("baseline", "avx2", "avx512"), or nullptr.
const DenseTable* dense_kernels_for(const char* name) noexcept;

}  // namespace hfrac
