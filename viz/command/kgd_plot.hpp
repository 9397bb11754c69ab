// SPDX-License-Identifier: BSD-3-Clause
// `hfrac plot DIR --kgd`: opening and pressure along the first well's fracture, at the last snapshot while fluid went in, beside the
// plane-strain solution (kgd.hpp) of the same volume.
#pragma once

#include <filesystem>
#include <string>

namespace hfrac::command {

/** The table of both for hfrac_viz_render_comparison. Throws BadInput if the run does not have what the solution needs. */
std::string kgd_table(const std::filesystem::path& folder);

}  // namespace hfrac::command
