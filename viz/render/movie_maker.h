// SPDX-License-Identifier: BSD-3-Clause
// A movie of a run: which snapshots become frames, and in what order the work is done. Finished pieces stay on the disk
// until the movie is, so a render that was killed goes on where it stopped, and one may follow a run that goes on.
#pragma once

#include <filesystem>

#include "render_run.h"

namespace hfrac::viz {

// To `target`, .mp4 or .webp. `options` has been checked. Throws Failure or Stopped.
void make_movie(const std::filesystem::path& folder, const std::filesystem::path& target,
                const hfrac_viz_options& options, const Progress& progress);

}  // namespace hfrac::viz
