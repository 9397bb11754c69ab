// SPDX-License-Identifier: BSD-3-Clause
// One cycle of multigrid (multigrid.hpp) as rows of parallel loops: what a worker does to its groups of rows and a card in blocks, one
// group to a block.
//
// `Block` gives each(n, item): item(k) for all k below n, in any order or at once, and nothing after it before all are done; `shared`:
// room for block_sums numbers; `serial`: whether it is one worker. Every row's sum is made in the order of its entries, so whoever
// does it gets the same bits.
#pragma once

#include "core/negligible.hpp"
#include "linear/multigrid_arrays.hpp"

namespace hfrac {
namespace {

inline int64_t end_of_group(const LevelArrays& l, int64_t group) {
  return (group + 1) * row_group < l.rows ? (group + 1) * row_group : l.rows;
}

// Row i of A x.
inline double product_of_row(const LevelArrays& l, const double* x, int64_t i) {
  double sum = l.diagonal[i] * x[i];
  for (int32_t k = l.start[i]; k < l.start[i + 1]; ++k) sum += l.value[k] * x[l.column[k]];
  return sum;
}

// Colour by colour, forward, from 0: into `before`.
template <class Block>
void smooth_from_nothing(Block& block, const LevelArrays& l, const double* b, int64_t group) {
  for (int32_t c = l.group_colour[group]; c < l.group_colour[group + 1]; ++c) {
    const int64_t first = l.colour_start[c];
    block.each(l.colour_start[c + 1] - first, [&](int64_t at) {
      const int64_t i = first + at;
      double sum = b[i];
      for (int32_t k = l.start[i]; k < l.upper[i]; ++k) sum -= l.value[k] * l.before[l.column[k]];
      l.before[i] = unless_negligible(sum / l.weight[i]);
    });
  }
}

// Rows from `first` up to `end` of the coarser level's right-hand side: right-hand side less product after the above, of which what
// lies below the diagonal was already taken away.
template <class Block>
void take_to_coarser(Block& block, const LevelArrays& l, const LevelArrays& coarse, int64_t first,
                     int64_t end) {
  block.each(end - first, [&](int64_t at) {
    double all = 0.0;
    for (int32_t m = l.first[first + at]; m < l.first[first + at + 1]; ++m) {
      const int32_t i = l.member[m];
      double sum = (l.weight[i] - l.diagonal[i]) * l.before[i];
      for (int32_t k = l.upper[i]; k < l.start[i + 1]; ++k) sum -= l.value[k] * l.before[l.column[k]];
      all += sum;
    }
    coarse.right[first + at] = unless_negligible(all);
  });
}

inline double corrected(const LevelArrays& l, const double* coarse, int64_t i) {
  return coarse == nullptr || l.aggregate[i] < 0 ? l.before[i]
                                                 : l.before[i] + l.share * coarse[l.aggregate[i]];
}

// Adds the coarser level's correction (null: none), then colour by colour backward: into z.
template <class Block>
void smooth_back(Block& block, const LevelArrays& l, const double* b, const double* coarse, double* z,
                 int64_t group) {
  const int64_t begin = group * row_group;
  block.each(end_of_group(l, group) - begin,
             [&](int64_t at) { z[begin + at] = corrected(l, coarse, begin + at); });
  for (int32_t c = l.group_colour[group + 1]; c-- > l.group_colour[group];) {
    const int64_t first = l.colour_start[c];
    block.each(l.colour_start[c + 1] - first, [&](int64_t at) {
      const int64_t i = first + at;
      double sum = b[i] - l.diagonal[i] * z[i];
      for (int32_t k = l.start[i]; k < l.outer[i]; ++k) sum -= l.value[k] * z[l.column[k]];
      for (int32_t k = l.outer[i]; k < l.start[i + 1]; ++k)
        sum -= l.value[k] * corrected(l, coarse, l.column[k]);
      z[i] = unless_negligible(z[i] + sum / l.weight[i]);
    });
  }
}

// What is left of the right-hand side after the coarser level's first visit: into `rest`.
template <class Block>
void find_rest_of_group(Block& block, const LevelArrays& l, int64_t group) {
  const int64_t first = group * row_group;
  block.each(end_of_group(l, group) - first, [&](int64_t at) {
    const int64_t i = first + at;
    l.rest[i] = unless_negligible(l.right[i] - product_of_row(l, l.after, i));
  });
}

// The second visit's correction, on top.
template <class Block>
void add_more(Block& block, const LevelArrays& l, int64_t group) {
  const int64_t first = group * row_group;
  block.each(end_of_group(l, group) - first, [&](int64_t at) { l.after[first + at] += l.more[first + at]; });
}

// z = A^-1 r of the coarsest level. One worker goes by columns, which its vectors like; the sums are the same.
template <class Block>
void solve_coarsest(Block& block, const LevelArrays& l, const double* r, double* z) {
  const int64_t n = l.rows;
  if constexpr (Block::serial) {
    for (int64_t i = 0; i < n; ++i) z[i] = 0.0;
    for (int64_t j = 0; j < n; ++j) {
      const double here = r[j];
      for (int64_t i = 0; i < n; ++i) z[i] += l.inverse[j * n + i] * here;
    }
  } else {
    block.each(n, [&](int64_t i) {
      double sum = 0.0;
      for (int64_t j = 0; j < n; ++j) sum += l.inverse[j * n + i] * r[j];
      z[i] = sum;
    });
  }
}

// From level `top`, of few rows, to the last one of `depth` and back.
template <class Block>
void visit_few(Block& block, const LevelArrays* levels, int64_t top, int64_t depth, const double* r,
               double* z) {
  const auto groups_of = [](const LevelArrays& l) { return (l.rows + row_group - 1) / row_group; };
  for (int64_t at = top; at < depth; ++at) {
    const LevelArrays& l = levels[at];
    const double* right = at == top ? r : l.right;
    double* to = at == top ? z : l.after;
    if (l.inverse != nullptr) {
      solve_coarsest(block, l, right, to);
      break;
    }
    for (int64_t g = 0; g < groups_of(l); ++g) smooth_from_nothing(block, l, right, g);
    if (at + 1 < depth) {
      take_to_coarser(block, l, levels[at + 1], 0, levels[at + 1].rows);
    } else {
      for (int64_t g = 0; g < groups_of(l); ++g) smooth_back(block, l, right, nullptr, to, g);
    }
  }
  for (int64_t at = depth - 1; at-- > top;) {
    const LevelArrays& l = levels[at];
    for (int64_t g = 0; g < groups_of(l); ++g)
      smooth_back(block, l, at == top ? r : l.right, levels[at + 1].after, at == top ? z : l.after, g);
  }
}

}  // namespace
}  // namespace hfrac
