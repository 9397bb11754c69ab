// SPDX-License-Identifier: BSD-3-Clause
// The short table that ends a run and that `hfrac info` prints; both come from summary.json.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace hfrac::command {

std::string summary_text(const nlohmann::ordered_json& summary);

/** The same with other words for how the run ended. */
std::string summary_text(const nlohmann::ordered_json& summary, const std::string& ended);

/** The short table of a run's result; if it is complete, also what is in the folder and what to do with it. */
void print_result(const std::filesystem::path& folder, bool complete);

}  // namespace hfrac::command
