// SPDX-License-Identifier: BSD-3-Clause
// Option structs that grow: a host compiled against an older header hands over a shorter one, and the members it does not
// know keep their defaults; one compiled against a newer header may hand over a longer one as long as it leaves what this
// library does not know at zero. And the defaults and ranges of each.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

#include "failure.h"
#include "hfrac/viz.h"

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

// What an option struct is called, its defaults, and its checks, which throw Failure(HFRAC_ERR_ARGUMENT).
template <class Options>
struct OptionStruct;

#define HFRAC_VIZ_OPTION_STRUCT_(type)         \
  template <>                                  \
  struct OptionStruct<type> {                  \
    static constexpr const char* name = #type; \
    static void set_defaults(type& o);         \
    static void check(const type& o);          \
  };
HFRAC_VIZ_OPTION_STRUCT_(hfrac_viz_options)
HFRAC_VIZ_OPTION_STRUCT_(hfrac_viz_chart_options)
HFRAC_VIZ_OPTION_STRUCT_(hfrac_viz_comparison_options)
HFRAC_VIZ_OPTION_STRUCT_(hfrac_viz_trace_options)
HFRAC_VIZ_OPTION_STRUCT_(hfrac_viz_view_options)
#undef HFRAC_VIZ_OPTION_STRUCT_

template <class Options>
Options default_options() {
  static_assert(std::is_trivially_copyable_v<Options>);
  Options options{};
  options.struct_size = static_cast<std::int32_t>(sizeof options);
  options.struct_version = 1;
  OptionStruct<Options>::set_defaults(options);
  return options;
}

// The host's struct at this library's size, checked. `from` NULL: the defaults.
template <class Options>
Options read_options(const Options* from) {
  const char* name = OptionStruct<Options>::name;
  Options full = default_options<Options>();
  if (from == nullptr) return full;
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
  std::memcpy(&full, from, std::min(given, sizeof(Options)));
  full.struct_size = static_cast<std::int32_t>(sizeof(Options));
  OptionStruct<Options>::check(full);
  return full;
}

// The defaults as far as the host's struct reaches. Never throws: a status.
template <class Options>
std::int32_t init_options(Options* to, std::int32_t struct_size) {
  if (to == nullptr) return HFRAC_ERR_ARGUMENT;
  if (!possible_struct_size(struct_size)) return HFRAC_ERR_STRUCT_SIZE;
  const auto defaults = default_options<Options>();
  const auto given = static_cast<std::size_t>(struct_size);
  auto* bytes = reinterpret_cast<unsigned char*>(to);
  std::memcpy(bytes, &defaults, std::min(given, sizeof(Options)));
  if (given > sizeof(Options)) std::memset(bytes + sizeof(Options), 0, given - sizeof(Options));
  std::memcpy(bytes, &struct_size, sizeof struct_size);
  return HFRAC_OK;
}

void check_range(const char* name, int value, int lowest, int highest, bool zero_allowed = false);

}  // namespace hfrac::viz
