// SPDX-License-Identifier: BSD-3-Clause
// What the emulated driver counts (emulated_driver.cpp); a real one counts nothing.
#pragma once

#include <dlfcn.h>

namespace emulated {

template <class Function>
Function find(const char* name) {
  static void* driver = dlopen("libcuda.so.1", RTLD_NOW | RTLD_LOCAL);
  return driver == nullptr ? nullptr : reinterpret_cast<Function>(dlsym(driver, name));
}

// Launches of a kernel so far; -1: unknown.
inline long launches(const char* kernel) {
  const auto count = find<long (*)(const char*)>("hfrac_emulated_launches");
  return count == nullptr ? -1 : count(kernel);
}

// Bytes that went to the card and came from it so far; negative: unknown.
struct Bytes {
  long long sent = -1, fetched = -1;
};
inline Bytes bytes() {
  Bytes b;
  if (const auto count = find<void (*)(long long*, long long*)>("hfrac_emulated_bytes"); count != nullptr)
    count(&b.sent, &b.fetched);
  return b;
}

}  // namespace emulated
