// SPDX-License-Identifier: BSD-3-Clause
// What the machine itself can do, measured beside the kernels so that a figure means something elsewhere.
#pragma once

#include <cstddef>

namespace hfrac::bench {

// Best of `rounds` of a[i] = b[i] + s c[i] over arrays of `count` doubles each: bytes a second, three arrays counted.
double triad(std::size_t count, int rounds);

}  // namespace hfrac::bench
