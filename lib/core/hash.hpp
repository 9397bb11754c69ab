// SPDX-License-Identifier: BSD-3-Clause
// A running hash of exact bits (FNV-1a over 64-bit words, with a final avalanche): equal states hash equal.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

namespace hfrac {

class Hash {
 public:
  void add(std::uint64_t word) {
    state_ ^= word;
    state_ *= 0x100000001b3ULL;
    state_ ^= state_ >> 29U;
  }
  // -0 and +0 are the same state.
  void add(double value) { add(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value)); }
  void add(std::int64_t value) { add(static_cast<std::uint64_t>(value)); }
  template <class T>
  void add_all(const T& values) {
    for (const auto& value : values) {
      if constexpr (std::is_floating_point_v<std::decay_t<decltype(value)>>) {
        add(static_cast<double>(value));
      } else {
        add(static_cast<std::uint64_t>(value));
      }
    }
  }
  [[nodiscard]] std::uint64_t value() const {
    std::uint64_t z = state_;
    z = (z ^ (z >> 33U)) * 0xff51afd7ed558ccdULL;
    return z ^ (z >> 33U);
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace hfrac
