// SPDX-License-Identifier: BSD-3-Clause
// The flow step's conjugate gradients on a device: each kernel one function of linear/multigrid_kernels.hpp or conjugate_kernels.hpp, which
// the processor's workers call, too; one block a group of rows.
//
// The numbers that an iteration needs of the one before (ConjugateState) stay on the device. Once it is done, what was launched
// after it returns at once, so the host asks only now and then.
#pragma once

#include "core/device_kernel.hpp"
#include "linear/conjugate_kernels.hpp"
#include "linear/multigrid_task.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

inline bool is_done(const MultigridTask& t) {
  return t.c.state->done != 0;
}

template <class Block>
void grid_smooth_forward(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  smooth_from_nothing(block, t.levels[t.level], t.r, block.number);
}

template <class Block>
void grid_take_to_coarser(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  const LevelArrays& coarse = t.levels[t.level + 1];
  const int64_t first = block.number * device_threads, end = first + device_threads;
  take_to_coarser(block, t.levels[t.level], coarse, first, end < coarse.rows ? end : coarse.rows);
}

template <class Block>
void grid_find_rest(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  find_rest_of_group(block, t.levels[t.level], block.number);
}

template <class Block>
void grid_add_more(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  add_more(block, t.levels[t.level], block.number);
}

template <class Block>
void grid_smooth_backward(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  const double* coarse = t.level + 1 < t.depth ? t.levels[t.level + 1].after : nullptr;
  smooth_back(block, t.levels[t.level], t.r, coarse, t.z, block.number);
}

template <class Block>
void grid_visit_few(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  visit_few(block, t.levels, t.level, t.depth, t.r, t.z);
}

template <class Block>
void gradient_begin_pass(Block& block, const MultigridTask& t) {
  begin_pass(block, t.c, t.levels[0], block.number);
}

template <class Block>
void gradient_take_first_length(Block& block, const MultigridTask& t) {
  const double all = total_of_groups(block, t.c.sums, t.c.groups);
  block.each(1, [&](int64_t) {
    ConjugateState& s = *t.c.state;
    s.length = __builtin_sqrt(all);
    s.target = larger(t.pass_tolerance * s.length, t.least_target);
    s.product = 1.0;
    s.iterations = 0;
    s.done = s.length > s.target ? 0 : 1;
  });
}

template <class Block>
void gradient_multiply_residuals(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  multiply_residuals(block, t.c, t.levels[0], block.number);
}

template <class Block>
void gradient_take_along(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  const double all = total_of_groups(block, t.c.sums, t.c.groups);
  block.each(1, [&](int64_t) { t.c.state->along = all; });
}

template <class Block>
void gradient_turn_direction(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  turn_direction(block, t.c, t.levels[0], t.c.state->along / t.c.state->product, block.number);
}

template <class Block>
void gradient_multiply_direction(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  multiply_direction(block, t.c, t.levels[0], block.number);
}

template <class Block>
void gradient_take_step(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  const double all = total_of_groups(block, t.c.others, t.c.groups);
  block.each(1, [&](int64_t) { t.c.state->step = t.c.state->along / all; });
}

template <class Block>
void gradient_go_along(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  go_along(block, t.c, t.levels[0], t.c.state->step, block.number);
}

template <class Block>
void gradient_take_length(Block& block, const MultigridTask& t) {
  if (is_done(t)) return;
  const double all = total_of_groups(block, t.c.sums, t.c.groups);
  block.each(1, [&](int64_t) {
    ConjugateState& s = *t.c.state;
    s.length = __builtin_sqrt(all);
    s.product = s.along;
    ++s.iterations;
    const bool finite = s.step - s.step == 0.0;
    s.done = finite && s.length > s.target ? 0 : 1;
  });
}

template <class Block>
void gradient_end_pass(Block& block, const MultigridTask& t) {
  end_pass(block, t.c, t.levels[0], block.number);
}

template <class Block>
void gradient_take_extremes(Block& block, const MultigridTask& t) {
  block.each(3, [&](int64_t which) {
    const double* of = which == 0 ? t.c.sums : which == 1 ? t.c.highest : t.c.lowest;
    double most = of[0];
    for (int64_t g = 1; g < t.c.groups; ++g) most = which == 2 ? smaller(most, of[g]) : larger(most, of[g]);
    (which == 0 ? t.c.state->change : which == 1 ? t.c.state->highest : t.c.state->lowest) = most;
  });
}

}  // namespace
}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac
