// SPDX-License-Identifier: BSD-3-Clause
// Pictures of chosen views of one snapshot: one with a wide column beside it, or several side by side.
#pragma once

#include <filesystem>
#include <vector>

#include "hfrac/viz.h"
#include "run/run_folder.hpp"
#include "view_layers.h"

namespace hfrac::viz {
using namespace hfrac::run;

// To `target`, .png, .svg or .pdf. `options` have been checked. Throws Failure or FileError.
void render_views(const RunFolder& run, const std::vector<ViewSpec>& specs,
                  const std::filesystem::path& target, const hfrac_viz_view_options& options);

}  // namespace hfrac::viz
