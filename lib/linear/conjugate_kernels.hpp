// SPDX-License-Identifier: BSD-3-Clause
// Conjugate gradients (conjugate_gradient.hpp) by groups of rows, as multigrid_kernels.hpp: what a worker does to its groups, a card to one
// a block.
//
// A sum over a group is made on 256 lanes, four rows to each, then on 16, then on one; a sum over groups likewise, 1024 of them at a
// time. That is quick in a block and in a processor's vectors, and the same bits whoever makes it.
#pragma once

#include "linear/multigrid_kernels.hpp"

namespace hfrac {
namespace {

inline double larger(double a, double b) {
  return a < b ? b : a;
}
inline double smaller(double a, double b) {
  return b < a ? b : a;
}

// term(0) + ... + term(count - 1), no more than row_group of them.
template <class Block, class Term>
double sum_of(Block& block, int64_t count, const Term& term) {
  double *lane = block.shared, *few = lane + sum_lanes, *all = few + few_lanes;
  if (count == row_group) {
    block.each(sum_lanes, [&](int64_t k) {
      lane[k] = ((term(k) + term(k + sum_lanes)) + term(k + 2 * sum_lanes)) + term(k + 3 * sum_lanes);
    });
  } else {
    block.each(sum_lanes, [&](int64_t k) {
      double sum = k < count ? term(k) : 0.0;
      for (int64_t i = k + sum_lanes; i < count; i += sum_lanes) sum += term(i);
      lane[k] = sum;
    });
  }
  block.each(few_lanes, [&](int64_t j) {
    double sum = lane[j];
    for (int64_t k = j + few_lanes; k < sum_lanes; k += few_lanes) sum += lane[k];
    few[j] = sum;
  });
  block.each(1, [&](int64_t) {
    double sum = few[0];
    for (int64_t j = 1; j < few_lanes; ++j) sum += few[j];
    *all = sum;
  });
  return *all;
}

// Of sums over groups.
template <class Block>
double total_of_groups(Block& block, const double* sums, int64_t groups) {
  double all = 0.0;
  for (int64_t begin = 0; begin < groups; begin += row_group) {
    const int64_t count = begin + row_group < groups ? row_group : groups - begin;
    all += sum_of(block, count, [&](int64_t k) { return sums[begin + k]; });
  }
  return all;
}

// In units of the diagonal's roots.
template <class Block>
double squared_length(Block& block, const LevelArrays& l, const double* r, int64_t group) {
  const int64_t first = group * row_group;
  return sum_of(block, end_of_group(l, group) - first,
                [&](int64_t k) { return r[first + k] * r[first + k] / l.diagonal[first + k]; });
}

// sums[group] = value, once it is known.
template <class Block>
void keep_sum(Block& block, double* sums, int64_t group, double value) {
  block.each(1, [&](int64_t) { sums[group] = value; });
}

// r = b - A x and its length; nothing found yet.
template <class Block>
void begin_pass(Block& block, const ConjugateArrays& c, const LevelArrays& l, int64_t group) {
  const int64_t first = group * row_group;
  block.each(end_of_group(l, group) - first, [&](int64_t at) {
    const int64_t i = first + at;
    c.r[i] = unless_negligible(c.b[i] - product_of_row(l, c.x, i));
    c.d[i] = c.p[i] = 0.0;
  });
  keep_sum(block, c.sums, group, squared_length(block, l, c.r, group));
}

// r z
template <class Block>
void multiply_residuals(Block& block, const ConjugateArrays& c, const LevelArrays& l, int64_t group) {
  const int64_t first = group * row_group;
  keep_sum(block, c.sums, group, sum_of(block, end_of_group(l, group) - first, [&](int64_t k) {
             return c.r[first + k] * c.z[first + k];
           }));
}

template <class Block>
void turn_direction(Block& block, const ConjugateArrays& c, const LevelArrays& l, double kept,
                    int64_t group) {
  const int64_t first = group * row_group;
  block.each(end_of_group(l, group) - first,
             [&](int64_t k) { c.p[first + k] = unless_negligible(c.z[first + k] + kept * c.p[first + k]); });
}

// A p into z, whose job is done, and p A p.
template <class Block>
void multiply_direction(Block& block, const ConjugateArrays& c, const LevelArrays& l, int64_t group) {
  const int64_t first = group * row_group, count = end_of_group(l, group) - first;
  block.each(count,
             [&](int64_t k) { c.z[first + k] = unless_negligible(product_of_row(l, c.p, first + k)); });
  keep_sum(block, c.others, group,
           sum_of(block, count, [&](int64_t k) { return c.p[first + k] * c.z[first + k]; }));
}

template <class Block>
void go_along(Block& block, const ConjugateArrays& c, const LevelArrays& l, double step, int64_t group) {
  const int64_t first = group * row_group;
  block.each(end_of_group(l, group) - first, [&](int64_t k) {
    c.d[first + k] = unless_negligible(c.d[first + k] + step * c.p[first + k]);
    c.r[first + k] = unless_negligible(c.r[first + k] - step * c.z[first + k]);
  });
  keep_sum(block, c.sums, group, squared_length(block, l, c.r, group));
}

// x + d, and how far a value moved at most, and the largest and smallest there are now.
template <class Block>
void end_pass(Block& block, const ConjugateArrays& c, const LevelArrays& l, int64_t group) {
  const int64_t first = group * row_group, count = end_of_group(l, group) - first;
  block.each(count, [&](int64_t k) { c.x[first + k] = unless_negligible(c.x[first + k] + c.d[first + k]); });
  block.each(3, [&](int64_t which) {
    const double* of = which == 0 ? c.d : c.x;
    double most = which == 0 ? 0.0 : of[first];
    for (int64_t k = 0; k < count; ++k) {
      const double value = of[first + k];
      most = which == 0   ? larger(most, value < 0.0 ? -value : value)
             : which == 1 ? larger(most, value)
                          : smaller(most, value);
    }
    (which == 0 ? c.sums : which == 1 ? c.highest : c.lowest)[group] = most;
  });
}

}  // namespace
}  // namespace hfrac
