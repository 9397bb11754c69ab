// SPDX-License-Identifier: BSD-3-Clause
// The one source of the dense kernels; included with HFRAC_DENSE_NAMESPACE and HFRAC_DENSE_WIDTH (doubles a vector) set.
// See dense_kernels.hpp.
#include "equilibrium/dense_kernels.hpp"

namespace hfrac {
namespace HFRAC_DENSE_NAMESPACE {
namespace {

typedef double Lanes  // NOLINT(modernize-use-using): attribute form
    __attribute__((vector_size(8 * HFRAC_DENSE_WIDTH), aligned(8), may_alias));
constexpr int64_t width = HFRAC_DENSE_WIDTH;
constexpr int64_t panel = 32;          // columns factored before the rest is updated
constexpr double least_pivot = 1e-13;  // of entries alike one in size
constexpr double good_pivot = 0.1;     // of the largest entry below: no exchange

// c[0..rows) of `columns` columns -= a b, k terms in order; rows = 2 vectors, columns = 4.
inline void tile(int64_t k, const double* __restrict a, int64_t lda, const double* __restrict b, int64_t ldb,
                 double* __restrict c, int64_t ldc) {
  Lanes sum[4][2];
  for (int64_t col = 0; col < 4; ++col) {
    for (int64_t half = 0; half < 2; ++half)
      sum[col][half] = *reinterpret_cast<const Lanes*>(c + col * ldc + half * width);
  }
  for (int64_t q = 0; q < k; ++q) {
    const Lanes a0 = *reinterpret_cast<const Lanes*>(a + q * lda);
    const Lanes a1 = *reinterpret_cast<const Lanes*>(a + q * lda + width);
    for (int64_t col = 0; col < 4; ++col) {
      const double factor = b[q + col * ldb];
      sum[col][0] -= a0 * factor;
      sum[col][1] -= a1 * factor;
    }
  }
  for (int64_t col = 0; col < 4; ++col) {
    for (int64_t half = 0; half < 2; ++half)
      *reinterpret_cast<Lanes*>(c + col * ldc + half * width) = sum[col][half];
  }
}

// The same for any number of rows and columns.
inline void edge(int64_t rows, int64_t columns, int64_t k, const double* __restrict a, int64_t lda,
                 const double* __restrict b, int64_t ldb, double* __restrict c, int64_t ldc) {
  for (int64_t col = 0; col < columns; ++col) {
    for (int64_t q = 0; q < k; ++q) {
      const double factor = b[q + col * ldb];
      for (int64_t row = 0; row < rows; ++row) c[row + col * ldc] -= a[row + q * lda] * factor;
    }
  }
}

void subtract_product(int64_t m, int64_t n, int64_t k, const double* a, int64_t lda, const double* b,
                      int64_t ldb, double* c, int64_t ldc) {
  constexpr int64_t rows = 2 * width;
  const int64_t whole_n = n - n % 4, whole_m = m - m % rows;
  for (int64_t i = 0; i < whole_m; i += rows) {
    for (int64_t j = 0; j < whole_n; j += 4) tile(k, a + i, lda, b + j * ldb, ldb, c + i + j * ldc, ldc);
  }
  if (whole_m < m) edge(m - whole_m, n, k, a + whole_m, lda, b, ldb, c + whole_m, ldc);
  if (whole_n < n) edge(whole_m, n - whole_n, k, a, lda, b + whole_n * ldb, ldb, c + whole_n * ldc, ldc);
}

void factor_front(double* w, int64_t m, int64_t p, int64_t ld, int32_t* swaps) {
  for (int64_t begin = 0; begin < p; begin += panel) {
    const int64_t end = begin + panel < p ? begin + panel : p;
    for (int64_t k = begin; k < end; ++k) {
      double* column = w + k * ld;
      int64_t best = k;
      double largest = __builtin_fabs(column[k]);
      for (int64_t r = k + 1; r < p; ++r) {
        if (good_pivot * __builtin_fabs(column[r]) > largest) {
          largest = __builtin_fabs(column[r]);
          best = r;
        }
      }
      swaps[k] = static_cast<int32_t>(best);
      if (best != k) {
        for (int64_t c = 0; c < m; ++c) {
          const double other = w[best + c * ld];
          w[best + c * ld] = w[k + c * ld];
          w[k + c * ld] = other;
        }
      }
      if (__builtin_fabs(column[k]) < least_pivot) column[k] = column[k] < 0.0 ? -least_pivot : least_pivot;
      const double inverse = 1.0 / column[k];
      for (int64_t r = k + 1; r < m; ++r) column[r] *= inverse;
      for (int64_t c = k + 1; c < end; ++c) {
        double* __restrict other = w + c * ld;
        const double factor = other[k];
        for (int64_t r = k + 1; r < m; ++r) other[r] -= column[r] * factor;
      }
    }
    // Rows of U right of the panel, then what is left.
    for (int64_t c = end; c < m; ++c) {
      double* __restrict column = w + c * ld;
      for (int64_t k = begin; k < end; ++k) {
        const double factor = column[k];
        const double* __restrict l = w + k * ld;
        for (int64_t r = k + 1; r < end; ++r) column[r] -= l[r] * factor;
      }
    }
    subtract_product(m - end, m - end, end - begin, w + end + begin * ld, ld, w + begin + end * ld, ld,
                     w + end + end * ld, ld);
  }
}

void forward(const double* columns, int64_t m, int64_t p, const int32_t* swaps, double* __restrict pivots,
             double* __restrict boundary) {
  for (int64_t k = 0; k < p; ++k) {
    const double other = pivots[swaps[k]];
    pivots[swaps[k]] = pivots[k];
    pivots[k] = other;
  }
  for (int64_t k = 0; k < p; ++k) {
    const double* __restrict l = columns + k * m;
    const double x = pivots[k];
    for (int64_t r = k + 1; r < p; ++r) pivots[r] -= l[r] * x;
    for (int64_t r = p; r < m; ++r) boundary[r - p] -= l[r] * x;
  }
}

void backward(const double* columns, const double* rows, int64_t m, int64_t p, double* __restrict pivots,
              const double* boundary) {
  for (int64_t c = 0; c < m - p; ++c) {
    const double* __restrict u = rows + c * p;
    const double x = boundary[c];
    for (int64_t r = 0; r < p; ++r) pivots[r] -= u[r] * x;
  }
  for (int64_t k = p - 1; k >= 0; --k) {
    const double* __restrict u = columns + k * m;
    const double x = pivots[k] / u[k];
    pivots[k] = x;
    for (int64_t r = 0; r < k; ++r) pivots[r] -= u[r] * x;
  }
}

}  // namespace

extern const DenseKernels table;
const DenseKernels table = {factor_front, forward, backward};

}  // namespace HFRAC_DENSE_NAMESPACE
}  // namespace hfrac
