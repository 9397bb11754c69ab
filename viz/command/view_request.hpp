// SPDX-License-Identifier: BSD-3-Clause
// Options of `hfrac render` for one picture: which views, of which part, when.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "command/drawing.hpp"

namespace hfrac::command {

struct ViewRequest {
  std::vector<std::string> names;  ///< of views; empty: the usual pictures are wanted
  std::string zoom = "whole";      ///< a word, or left,bottom,width,height in metres
  std::string target = "view.png";
  int32_t snapshot = -1;
};

void add_view_options(CLI::App& command, ViewRequest& request);

/** Draws the picture. Throws BadInput or std::runtime_error. */
void draw_views(const std::string& folder, const ViewRequest& request, const Paper& paper, int32_t height);

}  // namespace hfrac::command
