// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C, kill, a terminal that goes away, limits of a queue: the handler only raises a flag, the run ends cleanly at its
// next callback and leaves a checkpoint.
#pragma once

namespace hfrac::command {

/** From now on SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU and SIGXFSZ raise the flag. A second SIGINT or SIGTERM ends the
 * process at once. The last four stay ignored where the caller ignores them, as nohup does. A file growing past the
 * limit of the shell (ulimit -f) is an ordinary write error and raises no flag. */
void catch_interrupts();

/** Whether the flag is up. */
bool interrupted();

}  // namespace hfrac::command
