// SPDX-License-Identifier: BSD-3-Clause
#include "command/drawing.hpp"

#include <fmt/format.h>
#include <hfrac/viz.h>

#include <stdexcept>

#include "command/exit_code.hpp"
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {

int32_t show_drawing(void* line, double fraction, const char* what) {
  static_cast<ProgressLine*>(line)->show(
      fmt::format("drawing {:3.0f} %  {}", fraction * 100.0, what ? what : ""));
  return interrupted() ? 1 : 0;
}

std::string drawing_error() {
  return run::whole_text([](char* buffer, int32_t capacity, int32_t* needed) {
    return hfrac_viz_last_error(buffer, capacity, needed);
  });
}

bool drawing_stopped(int32_t status) {
  if (status == HFRAC_VIZ_ERR_READ || status == HFRAC_ERR_ARGUMENT) throw BadInput(drawing_error());
  if (status < 0) throw std::runtime_error(drawing_error());
  if (status == HFRAC_VIZ_INCOMPLETE) fmt::print(stderr, "hfrac: warning: {}\n", drawing_error());
  return status == HFRAC_STOPPED;
}

}  // namespace hfrac::command
