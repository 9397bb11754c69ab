// SPDX-License-Identifier: BSD-3-Clause
// What the report says in numbers, from summary.json. Every number may be missing: a dash stands for it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace hfrac::viz {

// A member by its path, "state.step"; NaN if it is missing or no number.
double number_at(const nlohmann::json& summary, const std::string& path);
// Empty if it is missing or no text.
std::string text_at(const nlohmann::json& summary, const std::string& path);

std::string key_numbers(const nlohmann::json& summary);
// What the library warned of; empty if of nothing.
std::string warning_list(const nlohmann::json& summary);
std::string fracture_table(const nlohmann::json& summary);
std::string well_table(const nlohmann::json& summary);
std::string balance_tables(const nlohmann::json& summary);
std::string version_table(const nlohmann::json& summary);

}  // namespace hfrac::viz
