// SPDX-License-Identifier: BSD-3-Clause
// A tested specimen as a picture: discs where they came to rest, cracks by mode, as an SVG file.
#pragma once

#include <string>
#include <vector>

namespace hfrac::command {

/** `discs` and `cracks` as hfrac_lab_copy_f64 gives them (5 values a row); `title` stands above. */
std::string specimen_svg(const std::vector<double>& discs, const std::vector<double>& cracks,
                         const std::string& title);

}  // namespace hfrac::command
