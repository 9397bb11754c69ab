// SPDX-License-Identifier: BSD-3-Clause
// JSON files, and numbers and texts in them by their path, "state.crack_count".
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace hfrac::run {

/** The object in `file`, its texts printable. Throws ReadError if the file is missing, or is no JSON object. */
nlohmann::ordered_json read_json(const std::filesystem::path& file);

/** What is at `path`: members of objects, indices of lists; nullptr if there is nothing. */
const nlohmann::ordered_json* member(const nlohmann::ordered_json& object, std::string_view path);
/** NaN if there is no number. */
double number_at(const nlohmann::ordered_json& object, std::string_view path);
/** Empty if there is no text. */
std::string text_at(const nlohmann::ordered_json& object, std::string_view path);

}  // namespace hfrac::run
