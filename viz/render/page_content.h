// SPDX-License-Identifier: BSD-3-Clause
// A finished page as the content of a file: pixels, or circles, lines and letters; the ending of its name says which.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "page.h"

namespace hfrac::viz {

// ".png", ".svg" or ".pdf". Throws Failure(HFRAC_ERR_ARGUMENT) for any other ending.
std::string picture_ending(const std::filesystem::path& target);

// `title`: of the document. dots_per_inch: how large a PNG or PDF is on paper, 0: not said (PDF: 96).
std::vector<std::uint8_t> page_content(Page& page, const std::string& ending, const std::string& title,
                                       int dots_per_inch);

}  // namespace hfrac::viz
