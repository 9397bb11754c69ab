// SPDX-License-Identifier: BSD-3-Clause
// Pictures of chosen views of one snapshot: one with a wide column beside it, or several side by side.
#pragma once

#include <string>
#include <vector>

#include "hfrac/viz.h"
#include "page.h"
#include "pictures.h"
#include "view_spec.h"

namespace hfrac::viz {

// The part of the model that is asked for: whole, around the cracks, on the first well, on the farthest tip, or
// the given box.
Extent zoomed(const RunFolder& run, const Scene& scene, const hfrac_viz_view_options& options);

// The same as the content of a file: PNG, SVG or PDF, as its ending says.
std::vector<std::uint8_t> view_file(const Studio& studio, const Scene& scene,
                                    const std::vector<ViewSpec>& views, const Extent& extent,
                                    const std::string& ending, int dots_per_inch);

}  // namespace hfrac::viz
