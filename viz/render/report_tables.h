// SPDX-License-Identifier: BSD-3-Clause
// What the report says in numbers, from summary.json. Every number may be missing: a dash stands for it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "run/json_file.hpp"

namespace hfrac::viz {

// Pieces of HTML: files turned into data addresses, tables.

// "data:image/png;base64,..."
std::string data_address(const std::string& kind, const std::string& content);

// An SVG file of a chart as part of a page: no header, and the palette's colours as CSS variables, so that it follows the
// page into the dark.
std::string inline_svg(const std::string& svg);

// The variables inline_svg refers to: "--ink: #1c1c20; ..."
std::string colour_variables(bool dark);

// Rows of a name and a value; both are escaped.
using Rows = std::vector<std::pair<std::string, std::string>>;
std::string name_table(const Rows& rows);

using namespace hfrac::run;

std::string key_numbers(const nlohmann::ordered_json& summary);
// What the library warned of; empty if of nothing.
std::string warning_list(const nlohmann::ordered_json& summary);
// Of the smooth joints, with its heading; empty without them.
std::string joint_table(const nlohmann::ordered_json& summary);
std::string fracture_table(const nlohmann::ordered_json& summary);
std::string well_table(const nlohmann::ordered_json& summary);
std::string balance_tables(const nlohmann::ordered_json& summary);
std::string version_table(const nlohmann::ordered_json& summary);

}  // namespace hfrac::viz
