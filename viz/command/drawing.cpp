// SPDX-License-Identifier: BSD-3-Clause
#include "command/drawing.hpp"

#include <fmt/format.h>
#include <hfrac/viz.h>

#include <cmath>
#include <stdexcept>

#include "command/exit_code.hpp"
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {

namespace {

constexpr double millimetres_per_inch = 25.4;
constexpr int32_t print_resolution = 300;  // [dots per inch]

}  // namespace

int32_t Paper::pixels() const {
  if (print > 0.0) return static_cast<int32_t>(std::lround(print / millimetres_per_inch * print_resolution));
  return width;
}

int32_t Paper::dots_per_inch() const {
  return print > 0.0 ? print_resolution : 0;
}

void add_paper_options(CLI::App& command, Paper& paper) {
  auto* width = command.add_option("--width", paper.width, "Width of the pictures in pixels")
                    ->check(CLI::Range(320, 8192));
  command.add_option("--print", paper.print, "Width on paper in millimetres, drawn at 300 dots per inch")
      ->check(CLI::Range(40.0, 690.0))
      ->excludes(width);
  command.add_flag("--dark", paper.dark, "Light on dark paper");
}

void add_format_options(CLI::App& command, Paper& paper) {
  command.add_flag("--svg", paper.svg, "SVG files too");
  command.add_flag("--pdf", paper.pdf, "PDF files too");
}

int32_t show_drawing(void* line, double fraction, const char* what) {
  static_cast<ProgressLine*>(line)->show(
      fmt::format("drawing {:3.0f} %  {}", fraction * 100.0, what ? what : ""));
  return interrupted() ? 1 : 0;
}

std::string drawing_error() {
  return run::whole_text(hfrac_viz_last_error);
}

bool drawing_stopped(int32_t status) {
  if (status == HFRAC_VIZ_ERR_READ || status == HFRAC_ERR_ARGUMENT) throw BadInput(drawing_error());
  if (status < 0) throw std::runtime_error(drawing_error());
  if (status == HFRAC_VIZ_INCOMPLETE) fmt::print(stderr, "hfrac: warning: {}\n", drawing_error());
  return status == HFRAC_STOPPED;
}

}  // namespace hfrac::command
