// SPDX-License-Identifier: BSD-3-Clause
// Sums of doubles without rounding on the way, so that any order of additions, and any split of them over workers and ranks, gives
// the same bits.
//
// Every finite double is an integer times 2^-1074. The sum is kept as such an integer, in words of 32 bits that are added up by
// themselves (a small superaccumulator: Neal 2015, arXiv 1505.05571); carries wait until the value is asked for, or until a word
// might run over. What it comes to is rounded once. Integers of several sums add up to those of the whole.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace hfrac {

class ExactSum {
 public:
  // The last word counts what is not a finite number.
  static constexpr std::size_t word_count = 70;

  void add(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto exponent = static_cast<std::int64_t>((bits >> 52U) & 0x7ffU);
    if (exponent == 0x7ff) {
      ++words_.back();
      return;
    }
    const std::uint64_t fraction = bits & 0xfffffffffffffU;
    const std::uint64_t mantissa = exponent == 0 ? fraction : fraction | (1ULL << 52U);
    const std::int64_t shift = exponent == 0 ? 0 : exponent - 1;
    const auto at = static_cast<std::size_t>(shift / 32);
    const auto by = static_cast<unsigned>(shift % 32);
    const std::uint64_t low = (mantissa & low_half) << by, high = (mantissa >> 32U) << by;
    const std::uint64_t middle = (low >> 32U) + (high & low_half);
    const std::int64_t sign = (bits >> 63U) != 0 ? -1 : 1;
    words_[at] += sign * static_cast<std::int64_t>(low & low_half);
    words_[at + 1] += sign * static_cast<std::int64_t>(middle);
    words_[at + 2] += sign * static_cast<std::int64_t>(high >> 32U);
    if (++added_ == most_added) carry();
  }

  // After this every word but the last two lies in [0, 2^32): sums over up to 2^30 ranks fit.
  void carry() {
    for (std::size_t k = 0; k + 2 < word_count; ++k) {
      const std::int64_t over = words_[k] >> 32;  // towards minus infinity
      words_[k] -= over * (std::int64_t{1} << 32);
      words_[k + 1] += over;
    }
    added_ = 0;
  }

  // The words themselves, to be added up with those of other ranks.
  [[nodiscard]] std::span<std::int64_t, word_count> words() { return words_; }

  // The sum, rounded to nearest; NaN if anything added was no finite number.
  [[nodiscard]] double value() const {
    if (words_.back() != 0) return std::numeric_limits<double>::quiet_NaN();
    ExactSum sum = *this;
    sum.carry();
    auto& w = sum.words_;
    const bool negative = w[word_count - 2] < 0;
    if (negative) {
      for (auto& word : w) word = -word;
      sum.carry();
    }
    std::size_t top = word_count - 2;
    while (top > 0 && w[top] == 0) --top;
    // 64 bits from the first that is set, and whether anything is set below them: rounds as the whole would.
    const auto bits_of = [&w](std::size_t k) { return static_cast<std::uint64_t>(w[k]); };
    std::uint64_t leading = bits_of(top);
    if (leading == 0) return 0.0;
    auto lowest = static_cast<std::int64_t>(top) * 32;  // power of two of its last bit
    const auto take = [&](std::size_t k, unsigned bits) {
      leading = (leading << bits) | (bits_of(k) >> (32U - bits));
      lowest -= bits;
    };
    std::size_t next = top;
    auto room = static_cast<unsigned>(std::countl_zero(leading));
    unsigned rest = 0;  // bits of w[next] that did not find room
    while (room > 0 && next > 0) {
      --next;
      const unsigned bits = room < 32U ? room : 32U;
      take(next, bits);
      room -= bits;
      rest = 32U - bits;
    }
    bool below = rest > 0 && (bits_of(next) & ((1ULL << rest) - 1)) != 0;
    while (next > 0 && !below) below = bits_of(--next) != 0;
    if (below) leading |= 1U;
    const double size = std::ldexp(static_cast<double>(leading), static_cast<int>(lowest) - 1074);
    return negative ? -size : size;
  }

 private:
  static constexpr std::uint64_t low_half = 0xffffffffU;
  static constexpr std::int64_t most_added = std::int64_t{1} << 29;

  std::array<std::int64_t, word_count> words_{};
  std::int64_t added_ = 0;
};

}  // namespace hfrac
