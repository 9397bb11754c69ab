// SPDX-License-Identifier: BSD-3-Clause
// The kernels for one instruction set; the compiler flags that go with it stand in lib/CMakeLists.txt.
#define HFRAC_KERNEL_NAMESPACE kernels_avx2
#define HFRAC_KERNEL_NAME "avx2"
#include "solid/kernels_body.hpp"
