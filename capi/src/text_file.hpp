// SPDX-License-Identifier: BSD-3-Clause
// Reading a small text file whole, or refusing at once.
#pragma once

#include <cstddef>
#include <string>

namespace hfrac::capi {

struct TextLimits {
  const char* kind;          // what it should be: "case file"
  std::size_t largest_file;  // bytes
  std::size_t longest_line;  // bytes
};
// A case file's lines bound the depth of a.b.c.d..., which its parser follows by recursion.
inline constexpr TextLimits case_limits{"case file", 1U << 20U, 4096};
inline constexpr TextLimits trace_table_limits{"table of traces", 1U << 26U, 4096};
inline constexpr TextLimits record_limits{"record", 1U << 26U, 4096};
inline constexpr TextLimits geojson_limits{"GeoJSON of traces", 1U << 26U, 1U << 26U};

// The text of a file. Refuses with Error(case_file) what is not a regular file, is above its limits or holds a byte 0, before more
// than that is read: a path to a device, a pipe or a huge file costs nothing.
std::string read_text_file(const std::string& path, const TextLimits& limits = case_limits);

}  // namespace hfrac::capi
