// SPDX-License-Identifier: BSD-3-Clause
// What the machine itself can do, measured beside the kernels so that a figure means something elsewhere.
#pragma once

#include <cstddef>

namespace hfrac::bench {

// Best of `rounds` of a[i] = b[i] + s c[i] over arrays of `count` doubles each, on `threads` threads with arrays of their own:
// bytes a second, three arrays counted.
double triad(std::size_t count, int rounds, int threads = 1);

// Multiplications and additions a second, in the widest vectors there are, nothing fused (the kernels fuse nothing).
double multiply_add(int rounds, int threads = 1);

}  // namespace hfrac::bench
