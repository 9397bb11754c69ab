// SPDX-License-Identifier: BSD-3-Clause
// A movie of a run: which snapshots become frames, and when the file is written. One that follows a run is paced by what the
// run plans, whether it is over by then or not, so that the same run gives the same movie.
#pragma once

#include <filesystem>

#include "render_run.h"

namespace hfrac::viz {

// To `target`, .mp4 or .webp. `options` has been checked. Throws Failure or Stopped.
void make_movie(const std::filesystem::path& folder, const std::filesystem::path& target,
                const hfrac_viz_options& options, const Progress& progress);

}  // namespace hfrac::viz
