// SPDX-License-Identifier: BSD-3-Clause
// What kernels of a device have in common: sums in a fixed order, and values that are to be fetched early. On a card a wait for
// memory is long, and all threads of a block wait for the slowest: so what a thread will need it asks for at once.
#pragma once

#include "solid/device_arrays.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

// Of values[from], values[from + every] ... up to `to`, one after the other; eight are fetched at once.
inline __attribute__((always_inline)) double sum_of_every(int32_t every, const double* values, int32_t from,
                                                          int32_t to, double sum) {
  constexpr int32_t at_once = 8;
  int32_t k = from;
  for (; k + (at_once - 1) * every < to; k += at_once * every) {
    double next[at_once];
    for (int32_t q = 0; q < at_once; ++q) next[q] = values[k + q * every];
    for (const double value : next) sum += value;
  }
  for (; k < to; k += every) sum += values[k];
  return sum;
}

// Has `value` at hand from here on: the compiler would fetch it where it is used, and all threads would wait once more.
inline __attribute__((always_inline)) void hold([[maybe_unused]] double value) {
#ifdef __CUDA__
  asm volatile("" ::"d"(value));
#endif
}

inline int64_t item_of(const DeviceTask& t, int64_t block) {
  return t.list != nullptr ? t.list[block] : block;
}

}  // namespace
}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac
