// SPDX-License-Identifier: BSD-3-Clause
// The short table that ends a run and that `hfrac info` prints; both come from summary.json.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace hfrac::command {

std::string summary_text(const nlohmann::json& summary);

}  // namespace hfrac::command
