// SPDX-License-Identifier: BSD-3-Clause
// A movie of a run: which snapshots become frames, and when the file is written. One that follows a run is paced by what the
// run plans, whether it is over by then or not, so that the same run gives the same movie.
#pragma once

#include <filesystem>
#include <vector>

#include "pictures.h"
#include "render_run.h"

namespace hfrac::viz {

// A movie's frame: the discs and cracks of a snapshot, beside them the curves as far as the run had come.

// The curves of the whole run so far, and the ranges their axes show in every frame.
struct MovieCurves {
  std::vector<double> time;      // [s]
  std::vector<double> pressure;  // [Pa] of the first well, NaN where unknown
  std::vector<double> cracks;
  double end_time = 0;      // [s]
  double top_pressure = 0;  // [Pa] 0 in a live movie: as each frame asks
  double top_cracks = 0;    // 0 in a live movie: as each frame asks
};

// From history.csv, or from the snapshots if there is none. `live`: the run goes on, so nothing is known of its end but
// what was planned.
MovieCurves movie_curves(const RunFolder& run, const std::vector<HistoryPoint>& history, bool live);

// Size of the frames; `studio` needs no window.
PictureSize movie_size(const Studio& studio, const Discs& discs);

void movie_frame(const Studio& studio, const Scene& scene, const MovieCurves& curves, const PageSink& sink);

// To `target`, .mp4 or .webp. `options` has been checked. Throws Failure or Stopped.
void make_movie(const std::filesystem::path& folder, const std::filesystem::path& target,
                const hfrac_viz_options& options, const Progress& progress);

}  // namespace hfrac::viz
