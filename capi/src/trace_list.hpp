// SPDX-License-Identifier: BSD-3-Clause
// What a table of traces and a GeoJSON of them have in common: traces are gathered one by one, each checked where it stands, so that a
// fault is told by file and line and a file of millions costs no memory.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/array.hpp"
#include "options/options.hpp"

namespace hfrac::capi {

class TraceList {
 public:
  // Traces of the file `path`; all but their ends as in `like`.
  TraceList(const std::string& path, const JointOptions& like) : path_(path), like_(like) {}

  std::size_t line = 1;  // where the reader is
  std::string part;      // of the file, beside the line: "feature 3: "

  // Throws Error(case_file): file, line, part, `fault`.
  [[noreturn]] void refuse(const std::string& fault) const;
  // Throws unless a coordinate [m] is a number that a joint's end may have.
  void check_coordinate(double value, std::string_view name, std::string_view shown) const;
  void add(Vec2 from, Vec2 to);
  std::vector<JointOptions> take() { return std::move(joints_); }

 private:
  const std::string& path_;
  const JointOptions& like_;
  std::vector<JointOptions> joints_;
};

void read_csv(std::string_view text, TraceList& traces);
void read_geojson(std::string_view text, TraceList& traces);

}  // namespace hfrac::capi
