// SPDX-License-Identifier: BSD-3-Clause
// How discs and bonds lie in memory: what the packing is numbered by, the arrays are laid out for and the kernels walk along.
//
// Included by the kernels (solid/kernels.hpp), so no standard templates here.
#pragma once

#include <stdint.h>  // NOLINT(modernize-deprecated-headers): see above

namespace hfrac {

// Discs in a row that form a tile: a patch of the plane whose displacements and forces fit the first-level cache
// (solid/tiles.hpp).
constexpr int64_t tile_size = 512;
// The values that make a bond, eight bonds side by side (model/bond_geometry.hpp): where in a block those of the first begin.
constexpr int64_t block_bonds = 8, block_values = 40;
constexpr int64_t block_dx = 0, block_dy = 8, block_length = 16, block_arm = 24, block_radius = 32;

}  // namespace hfrac
