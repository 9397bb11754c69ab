// SPDX-License-Identifier: BSD-3-Clause
// Position along a Hilbert curve (Hilbert 1891): points close on the curve are close in the plane, so discs numbered
// along it find their neighbours in cache.
#pragma once

#include <cstdint>

namespace hfrac {

// x and y in [0, 2^16).
inline std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y) {
  std::uint32_t d = 0;
  for (std::uint32_t s = 1U << 15U; s > 0; s >>= 1U) {
    const std::uint32_t rx = (x & s) != 0 ? 1U : 0U;
    const std::uint32_t ry = (y & s) != 0 ? 1U : 0U;
    d += s * s * ((3U * rx) ^ ry);
    if (ry == 0) {
      if (rx == 1) {
        x = 0xffffU - x;
        y = 0xffffU - y;
      }
      const std::uint32_t t = x;
      x = y;
      y = t;
    }
  }
  return d;
}

}  // namespace hfrac
