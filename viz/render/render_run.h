// SPDX-License-Identifier: BSD-3-Clause
// A whole run into pictures: which files, in which order, and the movie.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "hfrac/viz.h"

namespace hfrac::viz {

// Told the share done and what is at work; returns true to stop.
using Progress = std::function<bool(double fraction, const std::string& what)>;

// Thrown when Progress asked to stop.
struct Stopped {};

// `options` has been checked. All throw Failure or Stopped.
void render_run(const std::filesystem::path& folder, const hfrac_viz_options& options,
                const Progress& progress);
void render_picture(const std::filesystem::path& folder, int picture, const std::filesystem::path& target,
                    const hfrac_viz_options& options);
void render_movie(const std::filesystem::path& folder, const std::filesystem::path& target,
                  const hfrac_viz_options& options, const Progress& progress);

}  // namespace hfrac::viz
