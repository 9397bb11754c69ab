// SPDX-License-Identifier: BSD-3-Clause
// The kernels that a device has (gpu/device_kernel_list.inc, in this order), and the threads of a block.
//
// No standard templates here, since kernels include it (solid/kernels.hpp).
#pragma once

#include <stdint.h>  // NOLINT(modernize-deprecated-headers): see above

namespace hfrac {

enum DeviceKernel : int32_t {
  // cycles of the explicit solver (solid/device_arrays.hpp)
  device_cross_pairs,        // one block a pair of tiles
  device_plain_cross_pairs,  // likewise, in plain rock (gpu/device_kernels.hpp)
  device_large_pores,        // a pore of many corners across tiles
  device_cross_pores,        // a part
  device_press_walls,        // a block: 256 discs at walls
  device_push,               // one block: motion of walls under servo control, then non-bonded contacts
  device_tile_step,          // a tile: forces, then motion unless a bond exceeds its strength
  device_plain_tile_step,
  device_tile_move,   // a tile: motion by the forces held back
  device_momenta,     // a tile
  device_take_out,    // a tile: rigid motion out of it
  device_look_over,   // a tile: what it moves with, and whether all of it is a number
  device_clear_sums,  // a block: 256 tiles, pairs or parts
  // multigrid (linear/multigrid_kernels.hpp) of a level, one block a group of rows
  device_smooth_forward,
  device_take_to_coarser,  // a block: 256 rows of the coarser level
  device_find_rest,
  device_add_more,
  device_smooth_backward,
  device_visit_few,  // one block: this level, of few rows, and all coarser ones
  // conjugate gradients (linear/conjugate_kernels.hpp), one block a group of rows, or one for the sums over groups
  device_begin_pass,
  device_take_first_length,  // one block
  device_multiply_residuals,
  device_take_along,  // one block
  device_turn_direction,
  device_multiply_direction,
  device_take_step,  // one block
  device_go_along,
  device_take_length,  // one block
  device_end_pass,
  device_take_extremes,  // one block
  device_kernel_count
};

constexpr int64_t device_threads = 256;  // of most

}  // namespace hfrac
