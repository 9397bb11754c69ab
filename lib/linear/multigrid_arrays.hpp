// SPDX-License-Identifier: BSD-3-Clause
// Multigrid and conjugate gradients as plain arrays, of the processor's memory or of a device's: what the kernels (multigrid_kernels.hpp,
// conjugate_kernels.hpp) work on.
//
// No standard templates here, since kernels for devices include it (solid/kernels.hpp).
#pragma once

#include <stdint.h>  // NOLINT(modernize-deprecated-headers): see above

namespace hfrac {

// Rows that are smoothed together, and whose part of a scalar product is one sum.
constexpr int64_t row_group = 1024;
// A level of no more rows, and those below it, are visited once a cycle, by one worker or one block.
constexpr int64_t few_rows = 2048;
// Numbers from which a sum over a group is made (conjugate_kernels.hpp).
constexpr int64_t sum_lanes = 256, few_lanes = 16, block_sums = sum_lanes + few_lanes + 1;

// A matrix by rows, smoothed within groups. Rows of a group stand in order of colours: those of one colour do not depend on each other.
struct LevelArrays {
  int64_t rows;
  // Entries of row i: of its group, of colours before its own from start[i], of colours after it from upper[i]; of other groups from outer[i].
  const int32_t *start, *upper, *outer, *column;
  const double *value, *diagonal;
  const double* weight;         // the diagonal as the smoother takes it
  const int32_t* group_colour;  // of group g: its colours, group_colour[g] up to group_colour[g + 1]
  const int32_t* colour_start;  // of a colour: its first row
  const int32_t* aggregate;     // of a row: row of the coarser level; -1: none
  const int32_t *first,
      *member;  // of a row of the coarser level: its rows, first[g] up to first[g + 1] of member; null: no coarser level
  double share;           // of the coarser level's correction that is added
  const double* inverse;  // of the coarsest level's matrix, column by column; null: this one is smoothed
  double *right, *before, *after, *rest, *more;
};

// What the iterations have come to.
struct ConjugateState {
  double length, target;        // of the residual, squared and not
  double along, product, step;  // scalar products; product: of the iteration before
  double change, highest, lowest;
  int64_t iterations, done;  // done: 1 there is nothing to do, or the step was not finite
};

// b: right-hand side, x: solution, r: residual, d: change of x, p: direction, z: preconditioned residual, then A p. By row.
struct ConjugateArrays {
  int64_t groups;
  double *b, *x, *r, *d, *p, *z;
  double *sums, *others, *highest, *lowest;  // by group
  ConjugateState* state;
};

}  // namespace hfrac
