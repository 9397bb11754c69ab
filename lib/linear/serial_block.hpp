// SPDX-License-Identifier: BSD-3-Clause
// What a kernel of multigrid_kernels.hpp and conjugate_kernels.hpp takes for a block where one worker does it all.
#pragma once

#include <cstdint>

#include "linear/conjugate_kernels.hpp"

namespace hfrac {

struct SerialBlock {
  static constexpr bool serial = true;
  alignas(64) double shared[block_sums];
  template <class Item>
  void each(std::int64_t n, const Item& item) const {
    for (std::int64_t k = 0; k < n; ++k) item(k);
  }
};

}  // namespace hfrac
