// SPDX-License-Identifier: BSD-3-Clause
// What the commands that draw have in common: how large a picture is, on the screen or on paper, and in which light; progress on
// one line; and what becomes of the renderer's answer.
#pragma once

#include <hfrac/viz.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>

namespace hfrac::command {

struct Paper {
  int32_t width = 0;              ///< [pixel]; 0: the renderer's own choice
  double print = 0.0;             ///< [mm] width on paper, drawn at 300 dots per inch; 0: for the screen
  bool dark = false;              ///< light on dark paper
  bool svg = false, pdf = false;  ///< files of these kinds too

  /** [pixel] the width asked for in either way; 0: none. */
  int32_t pixels() const;
  int32_t dots_per_inch() const;
};

void add_paper_options(CLI::App& command, Paper& paper);
/** --svg and --pdf */
void add_format_options(CLI::App& command, Paper& paper);

/** A struct of options of the renderer: the defaults that its `init` gives, and what the user asked for. */
template <class Options>
Options options_for(const Paper& paper, int32_t (*init)(Options*, int32_t)) {
  Options options{};
  init(&options, static_cast<int32_t>(sizeof options));
  if (paper.pixels() > 0) options.width = paper.pixels();
  options.dots_per_inch = paper.dots_per_inch();
  options.dark = paper.dark ? 1 : 0;
  if constexpr (requires { options.formats; })
    options.formats |= (paper.svg ? HFRAC_VIZ_SVG : 0) | (paper.pdf ? HFRAC_VIZ_PDF : 0);
  return options;
}

/** What the renderer says of its last call on this thread. */
std::string drawing_error();

/** For hfrac_viz_progress_fn; the user's pointer is a ProgressLine. Stops when the user interrupts. */
int32_t show_drawing(void* line, double fraction, const char* what);

/** Throws what a negative status means: BadInput, or a failure. Says on stderr what is left out for lack of data. True if the
 * user stopped the drawing. */
bool drawing_stopped(int32_t status);

}  // namespace hfrac::command
