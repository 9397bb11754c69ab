// SPDX-License-Identifier: BSD-3-Clause
// Pictures of an analysis, each a table and what hfrac_viz_render_comparison makes of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "command/analysis.hpp"
#include "command/drawing.hpp"

namespace hfrac::command {

/** Beside NAME.png: NAME-record.png (pressure and rate over time), NAME-g.png (pressure and G dP/dG over G, its line and closure) and
 * NAME-root.png (pressure over the square root of time). Gives the files. Throws BadInput for an ending that is no picture. */
std::vector<std::string> draw_analysis(const Analysis& analysis, const InjectionRecord& record,
                                       const std::filesystem::path& picture, const Paper& paper);

}  // namespace hfrac::command
