// SPDX-License-Identifier: BSD-3-Clause
// The kernels for one instruction set; the compiler flags that go with it stand in lib/CMakeLists.txt.
#define HFRAC_KERNEL_NAMESPACE kernels_baseline
#define HFRAC_KERNEL_NAME "baseline"
#include "solid/kernels_body.hpp"
