// SPDX-License-Identifier: BSD-3-Clause
#include "command/drawing.hpp"

#include <fmt/format.h>
#include <hfrac/viz.h>

#include <stdexcept>

#include "command/exit_code.hpp"
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"

namespace hfrac::command {

int32_t show_drawing(void* line, double fraction, const char* what) {
  static_cast<ProgressLine*>(line)->show(
      fmt::format("drawing {:3.0f} %  {}", fraction * 100.0, what ? what : ""));
  return interrupted() ? 1 : 0;
}

bool drawing_stopped(int32_t status, const DrawingError& error) {
  if (status == HFRAC_VIZ_ERR_READ || status == HFRAC_ERR_ARGUMENT) throw BadInput(error.text.data());
  if (status < 0) throw std::runtime_error(error.text.data());
  return status == HFRAC_STOPPED;
}

}  // namespace hfrac::command
