// SPDX-License-Identifier: BSD-3-Clause
// A chunk of 64 bonds as arrays: the motion of their discs gathered from records, the forces scattered back to them. Part of the kernels
// (kernels_body.hpp).
//
// Records of discs are gathered four or eight at once and transposed into arrays (a gather instruction costs several times as much), laws
// run over the arrays in the widest vectors there are, and forces are transposed back and added to their discs.
#pragma once

#include "solid/kernels_law.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

// NOLINTNEXTLINE(modernize-use-using): attribute form
typedef double Quad __attribute__((vector_size(32), may_alias));

constexpr int64_t chunk = 64;  // bonds at a time; a multiple of 8

// Eight partial sums: the compiler may keep them in vector registers without changing the order of additions.
struct Partial {
  double lane[8];
};
inline double total(const Partial& p) {
  return total_of(p.lane);
}

// Adds n values in an order that does not depend on the vector width.
inline void add_up(Partial& sum, const double* __restrict values, int64_t n) {
  const int64_t whole = n & ~int64_t{7};
  for (int64_t k = 0; k < whole; k += 8) {
    for (int64_t lane = 0; lane < 8; ++lane) sum.lane[lane] += values[k + lane];
  }
  for (int64_t k = whole; k < n; ++k) sum.lane[k - whole] += values[k];
}

// So many bonds fill whole blocks of geometry; the law is found for blocks, since one bond alone costs as much as a block.
inline int64_t in_blocks(int64_t n) {
  return (n + block_bonds - 1) & ~(block_bonds - 1);
}

// The values of n bonds, or a copy in which the last stands in for those missing.
inline const double* whole_blocks(const double* values, int64_t n, double* copy) {
  if (n == in_blocks(n)) return values;
  for (int64_t k = 0; k < n; ++k) copy[k] = values[k];
  for (int64_t k = n; k < in_blocks(n); ++k) copy[k] = values[n - 1];
  return copy;
}

// A chunk of bonds as arrays: motion of their discs in, forces out.
struct alignas(64) Chunk {
  double dux[chunk], duy[chunk];       // m: second disc less first
  double turn[chunk], theta_i[chunk];  // rad: second disc less first; first disc
  double intact[chunk];
  double fx[chunk], fy[chunk], moment_i[chunk], minus_moment_j[chunk];
  double force[chunk], friction[chunk], over[chunk];  // for the sums
  double slip[chunk];                                 // after this cycle
  double start[chunk], worst[chunk];                  // likewise, of softening
};

// Four records a, b, c, d to four rows: row k holds lane k of each. Its own inverse.
inline __attribute__((always_inline)) void transpose(Quad& a, Quad& b, Quad& c, Quad& d) {
  const Quad ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6),
             ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Quad cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6),
             cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

// Arrays of n values each to records (x, y, z, 0). Arrays begin with a tile, so on a boundary of 64 bytes.
inline void to_records(const double* __restrict x, const double* __restrict y, const double* __restrict z,
                       int64_t n, Quad* __restrict records) {
  const int64_t whole = n & ~int64_t{3};
  for (int64_t k = 0; k < whole; k += 4) {
    Quad q0 = *reinterpret_cast<const Quad*>(x + k), q1 = *reinterpret_cast<const Quad*>(y + k),
         q2 = *reinterpret_cast<const Quad*>(z + k), q3 = {0.0, 0.0, 0.0, 0.0};
    transpose(q0, q1, q2, q3);
    records[k] = q0;
    records[k + 1] = q1;
    records[k + 2] = q2;
    records[k + 3] = q3;
  }
  for (int64_t k = whole; k < n; ++k) records[k] = Quad{x[k], y[k], z[k], 0.0};
}

// Motion of the discs of four bonds, from records (ux, uy, rotation, 0), to places `k` on of the chunk.
inline void gather_four(const Quad* at, const int32_t* i, const int32_t* j, int64_t k, Chunk& c) {
  Quad i0 = at[i[0]], i1 = at[i[1]], i2 = at[i[2]], i3 = at[i[3]];
  Quad d0 = at[j[0]] - i0, d1 = at[j[1]] - i1, d2 = at[j[2]] - i2, d3 = at[j[3]] - i3;
  transpose(d0, d1, d2, d3);
  transpose(i0, i1, i2, i3);
  *reinterpret_cast<Quad*>(c.dux + k) = d0;
  *reinterpret_cast<Quad*>(c.duy + k) = d1;
  *reinterpret_cast<Quad*>(c.turn + k) = d2;
  *reinterpret_cast<Quad*>(c.theta_i + k) = i2;
}

#ifdef __AVX512F__
// NOLINTNEXTLINE(modernize-use-using): attribute form
typedef double Oct __attribute__((vector_size(64), may_alias));

inline Oct side_by_side(const Quad& a, const Quad& b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}

inline void put_eight(const Quad& low, const Quad& high, double* to) {
  *reinterpret_cast<Oct*>(to) = side_by_side(low, high);
}

// Eight at once take half the shuffles of twice four.
inline void gather_eight(const Quad* at, const int32_t* i, const int32_t* j, int64_t k, Chunk& c) {
  const Oct i02 = side_by_side(at[i[0]], at[i[2]]), i13 = side_by_side(at[i[1]], at[i[3]]),
            i46 = side_by_side(at[i[4]], at[i[6]]), i57 = side_by_side(at[i[5]], at[i[7]]);
  const Oct d02 = side_by_side(at[j[0]], at[j[2]]) - i02, d13 = side_by_side(at[j[1]], at[j[3]]) - i13,
            d46 = side_by_side(at[j[4]], at[j[6]]) - i46, d57 = side_by_side(at[j[5]], at[j[7]]) - i57;
  const Oct even0 = __builtin_shufflevector(d02, d13, 0, 8, 2, 10, 4, 12, 6, 14),
            even4 = __builtin_shufflevector(d46, d57, 0, 8, 2, 10, 4, 12, 6, 14),
            odd0 = __builtin_shufflevector(d02, d13, 1, 9, 3, 11, 5, 13, 7, 15),
            odd4 = __builtin_shufflevector(d46, d57, 1, 9, 3, 11, 5, 13, 7, 15),
            theta0 = __builtin_shufflevector(i02, i13, 0, 8, 2, 10, 4, 12, 6, 14),
            theta4 = __builtin_shufflevector(i46, i57, 0, 8, 2, 10, 4, 12, 6, 14);
  *reinterpret_cast<Oct*>(c.dux + k) = __builtin_shufflevector(even0, even4, 0, 1, 4, 5, 8, 9, 12, 13);
  *reinterpret_cast<Oct*>(c.duy + k) = __builtin_shufflevector(odd0, odd4, 0, 1, 4, 5, 8, 9, 12, 13);
  *reinterpret_cast<Oct*>(c.turn + k) = __builtin_shufflevector(even0, even4, 2, 3, 6, 7, 10, 11, 14, 15);
  *reinterpret_cast<Oct*>(c.theta_i + k) =
      __builtin_shufflevector(theta0, theta4, 2, 3, 6, 7, 10, 11, 14, 15);
}
#else
inline void put_eight(const Quad& low, const Quad& high, double* to) {
  *reinterpret_cast<Quad*>(to) = low;
  *reinterpret_cast<Quad*>(to + 4) = high;
}

inline void gather_eight(const Quad* at, const int32_t* i, const int32_t* j, int64_t k, Chunk& c) {
  gather_four(at, i, j, k, c);
  gather_four(at, i + 4, j + 4, k + 4, c);
}
#endif

// Records (x, y, z, -) to arrays of n values each, and what fills the last eight up. Stored as wide as the loops behind read: a load
// wider than the store it follows waits until all stores before are in the cache.
inline void from_records(const Quad* records, int64_t n, double* x, double* y, double* z) {
  for (int64_t k = 0; k < n; k += 8) {
    Quad f[8];
    for (int64_t q = 0; q < 8; ++q) f[q] = records[k + q];
    transpose(f[0], f[1], f[2], f[3]);
    transpose(f[4], f[5], f[6], f[7]);
    put_eight(f[0], f[4], x + k);
    put_eight(f[1], f[5], y + k);
    put_eight(f[2], f[6], z + k);
  }
}

// Motion of the discs of n bonds. Records are counted from disc `base` on.
inline void gather(const int32_t* first, const int32_t* second, int64_t base, const Quad* records, int64_t n,
                   Chunk& c) {
  const Quad* at = records - base;
  int64_t k = 0;
  for (; k + 8 <= n; k += 8) gather_eight(at, first + k, second + k, k, c);
  for (; k < in_blocks(n); k += 4) {
    // The last block may not be full: the last bond stands in for those missing.
    int32_t i[4], j[4];
    for (int64_t q = 0; q < 4; ++q) {
      const int64_t bond = k + q < n ? k + q : n - 1;
      i[q] = first[bond];
      j[q] = second[bond];
    }
    gather_four(at, i, j, k, c);
  }
}

// Adds the chunk's forces to the records (fx, fy, moment, -) of their discs.
inline void scatter(const int32_t* first, const int32_t* second, int64_t base, Quad* records, int64_t n,
                    const Chunk& c) {
  Quad* at = records - base;
  const auto records_of = [&](int64_t k, Quad* f) {
    f[0] = *reinterpret_cast<const Quad*>(c.fx + k);
    f[1] = *reinterpret_cast<const Quad*>(c.fy + k);
    f[2] = *reinterpret_cast<const Quad*>(c.moment_i + k);
    f[3] = *reinterpret_cast<const Quad*>(c.minus_moment_j + k);
    transpose(f[0], f[1], f[2], f[3]);
  };
  const auto add = [&](int64_t bond, const Quad& force) {
    at[first[bond]] += force;
    at[second[bond]] -= __builtin_shufflevector(force, force, 0, 1, 3, 2);
  };
  int64_t k = 0;
  for (; k + 4 <= n; k += 4) {
    Quad f[4];
    records_of(k, f);
    add(k, f[0]);
    add(k + 1, f[1]);
    add(k + 2, f[2]);
    add(k + 3, f[3]);
  }
  if (k < n) {
    Quad f[4];
    records_of(k, f);
    for (int64_t q = 0; k + q < n; ++q) add(k + q, f[q]);
  }
}

}  // namespace
}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac
