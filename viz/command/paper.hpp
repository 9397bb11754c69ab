// SPDX-License-Identifier: BSD-3-Clause
// What the drawing commands share: how large a picture is, on the screen or on paper, and in which light.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace hfrac::command {

struct Paper {
  int32_t width = 0;   ///< [pixel]; 0: the renderer's own choice
  double print = 0.0;  ///< [mm] width on paper, drawn at 300 dots per inch; 0: for the screen
  bool dark = false;   ///< light on dark paper

  /** [pixel] the width asked for in either way; 0: none. */
  int32_t pixels() const;
  int32_t dots_per_inch() const;
};

void add_paper_options(CLI::App& command, Paper& paper);

}  // namespace hfrac::command
