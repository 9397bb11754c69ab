// SPDX-License-Identifier: BSD-3-Clause
// Option structs that grow: a host compiled against an older header hands over a shorter one, and the members it does not
// know keep their defaults; one compiled against a newer header may hand over a longer one as long as it leaves what this
// library does not know at zero.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

#include "failure.h"

namespace hfrac::viz {

// Larger than any struct of this interface will ever be; a size above is garbage, not a newer host.
inline constexpr std::int32_t largest_struct_size = 65536;

inline bool possible_struct_size(std::int32_t size) {
  return size >= 8 && size % 4 == 0 && size <= largest_struct_size;
}

// Throws Failure(HFRAC_ERR_STRUCT_SIZE).
[[noreturn]] inline void refuse_struct_size(const char* name, std::int32_t size) {
  throw Failure(HFRAC_ERR_STRUCT_SIZE, std::string(name) + ".struct_size is " + std::to_string(size) +
                                           ", not the size of that struct; fill it with " + name +
                                           "_init(&options, sizeof options) first");
}

// The host's struct at this library's size. `from` NULL: the defaults.
template <class Options>
Options read_options(const char* name, const Options* from, const Options& defaults) {
  static_assert(std::is_trivially_copyable_v<Options>);
  if (from == nullptr) return defaults;
  std::int32_t size = 0;
  std::memcpy(&size, from, sizeof size);  // all of *from may be shorter than Options
  if (!possible_struct_size(size)) refuse_struct_size(name, size);
  const auto given = static_cast<std::size_t>(size);
  const auto* bytes = reinterpret_cast<const unsigned char*>(from);
  for (std::size_t i = sizeof(Options); i < given; ++i) {
    if (bytes[i] != 0) {
      throw Failure(HFRAC_ERR_STRUCT_SIZE,
                    std::string(name) +
                        " was compiled against a newer header and uses a member this library does not know; "
                        "update the library");
    }
  }
  Options full = defaults;
  std::memcpy(&full, from, std::min(given, sizeof(Options)));
  full.struct_size = static_cast<std::int32_t>(sizeof(Options));
  return full;
}

// The defaults as far as the host's struct reaches. Never throws: a status.
template <class Options>
std::int32_t init_options(Options* to, std::int32_t struct_size, const Options& defaults) {
  static_assert(std::is_trivially_copyable_v<Options>);
  if (to == nullptr) return HFRAC_ERR_ARGUMENT;
  if (!possible_struct_size(struct_size)) return HFRAC_ERR_STRUCT_SIZE;
  const auto given = static_cast<std::size_t>(struct_size);
  auto* bytes = reinterpret_cast<unsigned char*>(to);
  std::memcpy(bytes, &defaults, std::min(given, sizeof(Options)));
  if (given > sizeof(Options)) std::memset(bytes + sizeof(Options), 0, given - sizeof(Options));
  std::memcpy(bytes, &struct_size, sizeof struct_size);
  return HFRAC_OK;
}

}  // namespace hfrac::viz
