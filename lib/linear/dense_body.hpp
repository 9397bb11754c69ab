// SPDX-License-Identifier: BSD-3-Clause
// The one source of the dense kernels; included with HFRAC_DENSE_NAMESPACE and HFRAC_DENSE_BYTES (of a vector) set.
// See dense_kernels.hpp.
#include "linear/dense_kernels.hpp"

namespace hfrac {
namespace HFRAC_DENSE_NAMESPACE {
namespace {

constexpr double good_pivot = 0.1;  // of the largest entry below: no exchange

inline float size_of(float x) {
  return __builtin_fabsf(x);
}
inline double size_of(double x) {
  return __builtin_fabs(x);
}

// Vectors of a number of bytes, and pivots below which a column counts as empty (entries are alike one in size).
template <class Real, int bytes>
struct Vector {
  typedef Real Lanes __attribute__((vector_size(bytes)));  // NOLINT(modernize-use-using): attribute form
};
// Rows begin anywhere, so vectors are copied from and to memory as bytes: one unaligned instruction each.
template <class Lanes, class Real>
inline void load(Lanes& to, const Real* from) {
  __builtin_memcpy(&to, from, sizeof to);
}
template <class Lanes, class Real>
inline void store(Real* to, const Lanes& from) {
  __builtin_memcpy(to, &from, sizeof from);
}
template <class Real>
constexpr Real least_pivot = sizeof(Real) == 4 ? Real(1e-7) : Real(1e-13);

template <class Real>
struct Dense {
  static constexpr int64_t sub_panel = 8;  // columns factored one by one
  static constexpr int full = HFRAC_DENSE_BYTES;

  // c[0..vectors) of `columns` columns -= a b, k terms in order, held in registers all the while.
  template <class Lanes, int vectors, int columns>
  static inline void tile(int64_t k, const Real* __restrict a, int64_t lda, const Real* __restrict b,
                          int64_t ldb, Real* __restrict c, int64_t ldc) {
    constexpr int64_t width = sizeof(Lanes) / sizeof(Real);
    Lanes sum[columns][vectors];
    for (int col = 0; col < columns; ++col) {
      for (int v = 0; v < vectors; ++v) load(sum[col][v], c + col * ldc + v * width);
    }
    for (int64_t q = 0; q < k; ++q) {
      Lanes left[vectors];
      for (int v = 0; v < vectors; ++v) load(left[v], a + q * lda + v * width);
      for (int col = 0; col < columns; ++col) {
        const Real factor = b[q + col * ldb];
        for (int v = 0; v < vectors; ++v) sum[col][v] -= left[v] * factor;
      }
    }
    for (int col = 0; col < columns; ++col) {
      for (int v = 0; v < vectors; ++v) store(c + col * ldc + v * width, sum[col][v]);
    }
  }

  // As many rows as make a number of vectors, from row i on; all columns.
  template <class Lanes, int vectors>
  static inline void strip(int64_t n, int64_t k, const Real* a, int64_t lda, const Real* b, int64_t ldb,
                           Real* c, int64_t ldc) {
    int64_t j = 0;
    for (; j + 4 <= n; j += 4) tile<Lanes, vectors, 4>(k, a, lda, b + j * ldb, ldb, c + j * ldc, ldc);
    for (; j < n; ++j) tile<Lanes, vectors, 1>(k, a, lda, b + j * ldb, ldb, c + j * ldc, ldc);
  }

  // c (m x n) -= a (m x k) b (k x n). If it may spill, rows are rounded up to whole vectors of 16 bytes: less than those behind
  // `a` are read, and behind `c` changed, where nothing that counts stands.
  template <bool spills>
  static void subtract_product(int64_t m, int64_t n, int64_t k, const Real* a, int64_t lda, const Real* b,
                               int64_t ldb, Real* c, int64_t ldc) {
    constexpr int64_t width = full / static_cast<int64_t>(sizeof(Real));
    constexpr int64_t least = 16 / static_cast<int64_t>(sizeof(Real));
    if constexpr (spills) m = (m + least - 1) / least * least;
    int64_t i = 0;
    if (n == 1) {
      for (; i + 4 * width <= m; i += 4 * width)
        tile<typename Vector<Real, full>::Lanes, 4, 1>(k, a + i, lda, b, ldb, c + i, ldc);
    }
    for (; i + 2 * width <= m; i += 2 * width)
      strip<typename Vector<Real, full>::Lanes, 2>(n, k, a + i, lda, b, ldb, c + i, ldc);
    if (i + width <= m) {
      strip<typename Vector<Real, full>::Lanes, 1>(n, k, a + i, lda, b, ldb, c + i, ldc);
      i += width;
    }
    if constexpr (full >= 64) {
      if (i + width / 2 <= m) {
        strip<typename Vector<Real, 32>::Lanes, 1>(n, k, a + i, lda, b, ldb, c + i, ldc);
        i += width / 2;
      }
    }
    if constexpr (full >= 32) {
      if (i + least <= m) {
        strip<typename Vector<Real, 16>::Lanes, 1>(n, k, a + i, lda, b, ldb, c + i, ldc);
        i += least;
      }
    }
    for (; i < m; ++i) {
      for (int64_t j = 0; j < n; ++j) {
        Real sum = c[i + j * ldc];
        for (int64_t q = 0; q < k; ++q) sum -= a[i + q * lda] * b[q + j * ldb];
        c[i + j * ldc] = sum;
      }
    }
  }

  // x := L^-1 x, unit lower triangle of n <= sub_panel rows.
  static inline void solve_corner(int64_t n, const Real* __restrict l, int64_t ldl, Real* __restrict x) {
    for (int64_t k = 0; k < n; ++k) {
      const Real factor = x[k];
      for (int64_t r = k + 1; r < n; ++r) x[r] -= l[r + k * ldl] * factor;
    }
  }

  // The same with all of sub_panel rows, for many columns: x -= (1 - L^-1) x, so that vectors go down the columns.
  static inline void solve_corners(const Real* l, int64_t ldl, Real* x, int64_t ldx, int64_t columns) {
    constexpr int bytes =
        full < sub_panel * static_cast<int>(sizeof(Real)) ? full : sub_panel * static_cast<int>(sizeof(Real));
    constexpr int vectors = sub_panel * static_cast<int>(sizeof(Real)) / bytes;
    constexpr int64_t width = bytes / static_cast<int64_t>(sizeof(Real));
    using Lanes = typename Vector<Real, bytes>::Lanes;
    Real rest[sub_panel * sub_panel] = {};  // 1 - L^-1 by columns
    for (int64_t c = 0; c < sub_panel; ++c) {
      Real* column = rest + c * sub_panel;
      for (int64_t r = c + 1; r < sub_panel; ++r) {
        Real sum = l[r + c * ldl];
        for (int64_t k = c + 1; k < r; ++k) sum -= l[r + k * ldl] * column[k];
        column[r] = sum;
      }
    }
    for (int64_t j = 0; j < columns; ++j) {
      Real* to = x + j * ldx;
      Lanes sum[vectors];
      for (int v = 0; v < vectors; ++v) load(sum[v], to + v * width);
      for (int64_t k = 0; k + 1 < sub_panel; ++k) {
        const Real factor = to[k];
        for (int v = 0; v < vectors; ++v) {
          Lanes next;
          load(next, rest + k * sub_panel + v * width);
          sum[v] -= next * factor;
        }
      }
      for (int v = 0; v < vectors; ++v) store(to + v * width, sum[v]);
    }
  }

  // The row at or below k to exchange with row k.
  static inline int64_t choose_pivot(const Real* column, int64_t k, int64_t p) {
    using Lanes = typename Vector<Real, full>::Lanes;
    constexpr int64_t width = full / static_cast<int64_t>(sizeof(Real));
    Real largest = 0;
    int64_t r = k + 1;
    if (p - r >= width) {
      Lanes most = {};
      for (; r + width <= p; r += width) {
        Lanes x;
        load(x, column + r);
        const Lanes size = x < 0 ? -x : x;
        most = size > most ? size : most;
      }
      for (int64_t q = 0; q < width; ++q) largest = most[q] > largest ? most[q] : largest;
    }
    for (; r < p; ++r) largest = size_of(column[r]) > largest ? size_of(column[r]) : largest;
    if (!(static_cast<Real>(good_pivot) * largest > size_of(column[k]))) return k;
    for (r = k + 1; r < p; ++r) {
      if (size_of(column[r]) == largest) return r;
    }
    return k;
  }

  static void factor_panel(Real* w, int64_t m, int64_t p, int64_t ld, int64_t begin, int64_t end,
                           int32_t* swaps) {
    constexpr Real least = least_pivot<Real>;
    for (int64_t first = begin; first < end; first += sub_panel) {
      const int64_t last = first + sub_panel < end ? first + sub_panel : end;
      for (int64_t k = first; k < last; ++k) {
        Real* column = w + k * ld;
        solve_corner(k - first, w + first + first * ld, ld, column + first);
        subtract_product<true>(m - k, 1, k - first, w + k + first * ld, ld, column + first, ld, column + k,
                               ld);
        const int64_t best = choose_pivot(column, k, p);
        swaps[k] = static_cast<int32_t>(best);
        if (best != k) {
          for (int64_t c = 0; c < m; ++c) {
            const Real other = w[best + c * ld];
            w[best + c * ld] = w[k + c * ld];
            w[k + c * ld] = other;
          }
        }
        if (size_of(column[k]) < least) column[k] = column[k] < Real(0) ? -least : least;
        const Real inverse = Real(1) / column[k];
        for (int64_t r = k + 1; r < m; ++r) column[r] *= inverse;
      }
      update(w, m, ld, first, last, last, end);
    }
  }

  static void update(Real* w, int64_t m, int64_t ld, int64_t begin, int64_t end, int64_t first,
                     int64_t last) {
    // Rows of U right of the panel, then what is left.
    for (int64_t k = begin; k < end; k += sub_panel) {
      const int64_t n = k + sub_panel < end ? sub_panel : end - k;
      if (n == sub_panel) {
        solve_corners(w + k + k * ld, ld, w + k + first * ld, ld, last - first);
      } else {
        for (int64_t c = first; c < last; ++c) solve_corner(n, w + k + k * ld, ld, w + k + c * ld);
      }
      subtract_product<false>(end - k - n, last - first, n, w + k + n + k * ld, ld, w + k + first * ld, ld,
                              w + k + n + first * ld, ld);
    }
    subtract_product<true>(m - end, last - first, end - begin, w + end + begin * ld, ld,
                           w + begin + first * ld, ld, w + end + first * ld, ld);
  }

  static void factor_front(Real* w, int64_t m, int64_t p, int64_t ld, int32_t* swaps) {
    for (int64_t begin = 0; begin < p; begin += dense_panel) {
      const int64_t end = begin + dense_panel < p ? begin + dense_panel : p;
      factor_panel(w, m, p, ld, begin, end, swaps);
      update(w, m, ld, begin, end, end, m);
    }
  }

  static void forward(const Real* columns, int64_t m, int64_t p, const int32_t* swaps, Real* pivots) {
    for (int64_t k = 0; k < p; ++k) {
      const Real other = pivots[swaps[k]];
      pivots[swaps[k]] = pivots[k];
      pivots[k] = other;
    }
    for (int64_t k = 0; k < p; k += sub_panel) {
      const int64_t n = k + sub_panel < p ? sub_panel : p - k;
      solve_corner(n, columns + k + k * m, m, pivots + k);
      subtract_product<true>(p - k - n, 1, n, columns + k + n + k * m, m, pivots + k, p, pivots + k + n, p);
    }
  }

  static void below(const Real* columns, int64_t m, int64_t p, const Real* pivots, Real* boundary,
                    int64_t first, int64_t last) {
    subtract_product<true>(last - first, 1, p, columns + p + first, m, pivots, p, boundary + first, m);
  }

  static void right(const Real* rows, int64_t p, int64_t b, const Real* boundary, Real* pivots, int64_t first,
                    int64_t last) {
    subtract_product<true>(last - first, 1, b, rows + first, p, boundary, b, pivots + first, p);
  }

  static void backward(const Real* columns, int64_t m, int64_t p, Real* pivots) {
    for (int64_t end = p; end > 0;) {
      const int64_t begin = (end - 1) / sub_panel * sub_panel;
      for (int64_t k = end - 1; k >= begin; --k) {
        const Real* u = columns + k * m;
        const Real x = pivots[k] / u[k];
        pivots[k] = x;
        for (int64_t r = begin; r < k; ++r) pivots[r] -= u[r] * x;
      }
      subtract_product<false>(begin, 1, end - begin, columns + begin * m, m, pivots + begin, p, pivots, p);
      end = begin;
    }
  }

  static constexpr DenseKernels<Real> kernels{factor_front, factor_panel, update,  forward,
                                              below,        right,        backward};
};

}  // namespace

extern const DenseTable table;
const DenseTable table = {Dense<float>::kernels, Dense<double>::kernels};

}  // namespace HFRAC_DENSE_NAMESPACE
}  // namespace hfrac
