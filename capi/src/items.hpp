// SPDX-License-Identifier: BSD-3-Clause
// Arrays of structs whose size in the caller may differ from ours: the common head of each item is what both know.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "internal.hpp"

namespace hfrac::capi {

inline void require_item_size(std::int32_t size, const char* name) {
  if (size < 8 || size > struct_size_limit) {
    throw Error(ErrorKind::struct_size, std::string(name) + " = " + std::to_string(size) +
                                            " cannot be a struct's size; give sizeof the struct.");
  }
}

// Item `index` of the caller's array; what the caller knows beyond ours is zeroed.
template <class Struct>
void put_item(Struct* buffer, std::int64_t index, std::int32_t size, const Struct& item) {
  auto* to = reinterpret_cast<unsigned char*>(buffer) + index * size;
  const auto common = std::min<std::size_t>(static_cast<std::size_t>(size), sizeof item);
  std::memcpy(to, &item, common);
  std::memset(to + common, 0, static_cast<std::size_t>(size) - common);
}

// The way back: what the caller does not know is zero.
template <class Struct>
Struct take_item(const Struct* buffer, std::int64_t index, std::int32_t size) {
  Struct item{};
  std::memcpy(&item, reinterpret_cast<const unsigned char*>(buffer) + index * size,
              std::min<std::size_t>(static_cast<std::size_t>(size), sizeof item));
  return item;
}

}  // namespace hfrac::capi
