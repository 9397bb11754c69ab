// SPDX-License-Identifier: BSD-3-Clause
// Under the thread sanitizer a test runs some ten times longer. It looks for races there, which one number of several workers shows
// like any other; that all numbers give the same bits is what the same test shows without it.
#pragma once

#include <vector>

namespace thread_sanitizer {

#ifdef __SANITIZE_THREAD__
inline constexpr bool watches = true;
#else
inline constexpr bool watches = false;
#endif

// Those to try: all, or those that do for races.
inline std::vector<int> numbers(std::vector<int> all, std::vector<int> for_races) {
  return watches ? for_races : all;
}

}  // namespace thread_sanitizer
