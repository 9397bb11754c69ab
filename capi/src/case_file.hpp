// SPDX-License-Identifier: BSD-3-Clause
// Case files: TOML with a table per section of the options, [[well]] for each well, [[well.schedule]] for each turn of it,
// [[joint]] for each line of weakness, and a title.
//
//   title = "hole under pressure"
//   [packing]
//   disc_count = 2000
//   [[well]]            # x and y left out: the model's centre
//   radius = 6.0
//   pressure = 45e6
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "options/options.hpp"

namespace hfrac::capi {

// Reads a case file over `base`. A file with wells replaces those of `base` with their schedules, one with joints its joints. Throws Error(case_file) with one
// sentence "path:line: what is wrong and what is allowed". Adds to `notes`, unless it is nullptr, what became of each well's record.
CaseDefinition load_case(const std::string& path, const CaseDefinition& base,
                         std::vector<std::string>* notes = nullptr);

// The record that the first well with a schedule_file names, and that well's schedule_thickness [m]; 0: it gives none.
struct NamedRecord {
  std::string path;
  double thickness;
};
std::optional<NamedRecord> record_of_case(const std::string& path);

// Where the values of a case file stand: "packing.disc_count", "well[0]", "well[0].radius", "schedule[2].time" and the line.
using KeyLines = std::map<std::string, std::size_t, std::less<>>;

// Of a file that load_case takes.
KeyLines lines_of_keys(const std::string& path);

// A sentence about a definition with the case file it came from before it, and the line of the first value named in the
// sentence that the file has: "path:line: sentence".
std::string with_place(const std::string& path, const KeyLines& lines, std::string_view sentence);

// A case file with every value; loading it gives the same definition. Throws Error(argument) if a value is
// out of range, so that what is written can be read.
std::string case_text(const CaseDefinition& definition);

// "well.radus is not a known key; did you mean well.radius?", for the lists well, joint and schedule.
std::string unknown_item_key_text(std::string_view list, std::string_view name);

}  // namespace hfrac::capi
