// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C and kill: the handler only raises a flag, the run ends cleanly at its next callback.
#pragma once

namespace hfrac::command {

/** From now on SIGINT and SIGTERM raise the flag; a second one ends the process at once. A file growing past
 * the limit of the shell (ulimit -f) becomes an ordinary write error instead of a silent death. */
void catch_interrupts();

/** Whether the flag is up. */
bool interrupted();

}  // namespace hfrac::command
