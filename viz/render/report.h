// SPDX-License-Identifier: BSD-3-Clause
// A run as one page of HTML that holds everything it shows and asks for nothing from anywhere.
#pragma once

#include <filesystem>
#include <string>

namespace hfrac::viz {

// The page, from case.toml, summary.json and the pictures, charts (SVG) and movie that are in `folder`/pictures.
// Throws ReadError.
std::string report_page(const std::filesystem::path& folder);

}  // namespace hfrac::viz
