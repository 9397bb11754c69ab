// SPDX-License-Identifier: BSD-3-Clause
// The kernels for a card of NVIDIA's: compiled by clang to PTX without any CUDA package (lib/gpu/CMakeLists.txt), which the driver
// translates for the card it finds.
#define HFRAC_KERNEL_NAMESPACE kernels_device
#pragma clang force_cuda_host_device begin
#include "gpu/device_gradient_kernels.hpp"
#include "gpu/device_kernels.hpp"
#pragma clang force_cuda_host_device end

extern __attribute__((shared)) double hfrac_shared[];

namespace {

// The threads of this block share out the items of a loop, and wait for each other at its end.
template <int64_t threads>
struct CardBlock {
  static constexpr bool serial = false;
  int64_t number;
  double* shared;
  template <class Item>
  __attribute__((device)) void each(int64_t n, const Item& item) const {
    for (int64_t k = __nvvm_read_ptx_sreg_tid_x(); k < n; k += threads) item(k);
    __syncthreads();
  }
};

}  // namespace

using hfrac::device_threads;
#define HFRAC_DEVICE_KERNEL(name, Task, threads, blocks)                                              \
  extern "C" __attribute__((global)) __attribute__((launch_bounds(threads, blocks))) void name(       \
      const hfrac::Task task) {                                                                      \
    CardBlock<threads> block{__nvvm_read_ptx_sreg_ctaid_x(), hfrac_shared};                          \
    hfrac::kernels_device::name(block, task);                                                        \
  }
#include "gpu/device_kernel_list.inc"
