// SPDX-License-Identifier: BSD-3-Clause
// The dense kernels for one instruction set; the compiler flags that go with it stand in lib/CMakeLists.txt.
#define HFRAC_DENSE_NAMESPACE dense_avx2
#define HFRAC_DENSE_BYTES 32
#include "linear/dense_body.hpp"
