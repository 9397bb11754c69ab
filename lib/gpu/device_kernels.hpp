// SPDX-License-Identifier: BSD-3-Clause
// The step loop on a device, as blocks of threads: one source, compiled to PTX for a card and to a loop over threads for tests without one.
//
// A kernel is a row of parallel loops, `block.each(n, f)`: f(0) to f(n - 1) by whichever threads, in any order, and all of them before what
// follows. What one tile's discs and bonds need of each other goes through the block's own memory, `block.shared`. Laws are those of
// solid/kernels_law.hpp and sums are made in the order of solid/kernels_body.hpp, so results are the processor's to the last bit.
//
// A cycle is two stages: bonds and pores across tiles with boundary and non-bonded contacts; then tiles. A bond that exceeds its strength ends the
// batch with its stage: what comes later returns at once, the host breaks bonds and goes on from there (solid/device_cycles.cpp).
// Plain rock has kernels of its own (device_bonds.hpp).
#pragma once

#include "gpu/device_bonds.hpp"
#include "gpu/device_looks.hpp"
#include "gpu/device_outside.hpp"
#include "gpu/device_pores.hpp"
#include "gpu/device_tiles.hpp"
