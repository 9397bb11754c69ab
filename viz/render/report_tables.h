// SPDX-License-Identifier: BSD-3-Clause
// What the report says in numbers, from summary.json. Every number may be missing: a dash stands for it.
#pragma once

#include <string>

#include "run/json_file.hpp"

namespace hfrac::viz {
using namespace hfrac::run;

std::string key_numbers(const nlohmann::ordered_json& summary);
// What the library warned of; empty if of nothing.
std::string warning_list(const nlohmann::ordered_json& summary);
std::string fracture_table(const nlohmann::ordered_json& summary);
std::string well_table(const nlohmann::ordered_json& summary);
std::string balance_tables(const nlohmann::ordered_json& summary);
std::string version_table(const nlohmann::ordered_json& summary);

}  // namespace hfrac::viz
