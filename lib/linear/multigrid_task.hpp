// SPDX-License-Identifier: BSD-3-Clause
// What a launch of a kernel of multigrid or conjugate gradients is told (linear/device_conjugate_gradient.hpp, gpu/device_kernels.hpp).
#pragma once

#include "linear/multigrid_arrays.hpp"

namespace hfrac {

struct MultigridTask {
  const LevelArrays* levels;
  int64_t level, depth;  // the one at hand; how many there are
  const double* r;       // what a level is solved for, and where its answer goes
  double* z;
  ConjugateArrays c;
  double pass_tolerance,
      least_target;  // of the residual's length: over the first one, and however long that was
};

// Bytes of a block's own memory.
constexpr int64_t grid_shared_bytes = block_sums * 8;

}  // namespace hfrac
