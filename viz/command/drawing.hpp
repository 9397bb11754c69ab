// SPDX-License-Identifier: BSD-3-Clause
// What the commands that draw have in common: progress on one line, and what becomes of the renderer's answer.
#pragma once

#include <cstdint>
#include <string>

namespace hfrac::command {

/** What the renderer says of its last call on this thread. */
std::string drawing_error();

/** For hfrac_viz_progress_fn; the user's pointer is a ProgressLine. Stops when the user interrupts. */
int32_t show_drawing(void* line, double fraction, const char* what);

/** Throws what a negative status means: BadInput, or a failure. Says on stderr what is left out for lack of data. True if the
 * user stopped the drawing. */
bool drawing_stopped(int32_t status);

}  // namespace hfrac::command
