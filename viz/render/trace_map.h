// SPDX-License-Identifier: BSD-3-Clause
// Traces of natural fractures on one page: where they lie, which way they look, how long they are.
#pragma once

#include <cstdint>
#include <filesystem>

#include "hfrac/viz.h"

namespace hfrac::viz {

// See hfrac_viz_render_traces. `options` have been checked. Throws Failure or FileError.
void render_traces(const double* ends, const std::int32_t* sets, std::int64_t count,
                   const std::filesystem::path& target, const hfrac_viz_trace_options& options);

}  // namespace hfrac::viz
