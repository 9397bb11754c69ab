// SPDX-License-Identifier: BSD-3-Clause
// What the commands that draw have in common: progress on one line, and what becomes of the renderer's answer.
#pragma once

#include <array>
#include <cstdint>

namespace hfrac::command {

/** The reason of a failed call, as the renderer's functions fill it. */
struct DrawingError {
  std::array<char, 2048> text{};
  int32_t capacity() const { return static_cast<int32_t>(text.size()); }
};

/** For hfrac_viz_progress_fn; the user's pointer is a ProgressLine. Stops when the user interrupts. */
int32_t show_drawing(void* line, double fraction, const char* what);

/** Throws what a negative status means: BadInput, or a failure. True if the user stopped the drawing. */
bool drawing_stopped(int32_t status, const DrawingError& error);

}  // namespace hfrac::command
