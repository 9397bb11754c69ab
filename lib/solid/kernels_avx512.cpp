// SPDX-License-Identifier: BSD-3-Clause
// The kernels for one instruction set; the compiler flags that go with it stand in lib/CMakeLists.txt.
#define HFRAC_KERNEL_NAMESPACE kernels_avx512
#define HFRAC_KERNEL_NAME "avx512"
#include "solid/kernels_body.hpp"
