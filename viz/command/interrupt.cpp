// SPDX-License-Identifier: BSD-3-Clause
// sig_atomic_t is all that a handler may touch safely.
#include "command/interrupt.hpp"

#include <unistd.h>

#include <csignal>

namespace hfrac::command {
namespace {

volatile std::sig_atomic_t interrupt_flag = 0;

extern "C" void raise_flag(int) {
  interrupt_flag = 1;
}

/** A write of this process that goes past its limit on file size sends SIGXFSZ as from the process itself, and fails: whoever
 * wrote deals with it. Only one sent from outside asks for the end. */
extern "C" void raise_flag_if_sent(int, siginfo_t* info, void*) {
  if (info->si_pid != ::getpid()) interrupt_flag = 1;
}

void handle(int signal, int flags, bool keep_ignored) {
  struct sigaction action {};
  if (keep_ignored && sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) return;
  action = {};
  if ((flags & SA_SIGINFO) != 0)
    action.sa_sigaction = raise_flag_if_sent;
  else
    action.sa_handler = raise_flag;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_interrupts() {
  const auto once = static_cast<int>(SA_RESETHAND);
  handle(SIGINT, once, false);
  handle(SIGTERM, once, false);
  // These come again before the run has ended: at every write into the pipe, every second beyond the limit of time.
  handle(SIGHUP, SA_RESTART, true);
  handle(SIGPIPE, SA_RESTART, true);
  handle(SIGXCPU, SA_RESTART, true);
  handle(SIGXFSZ, SA_RESTART | SA_SIGINFO, true);
}

bool interrupted() {
  return interrupt_flag != 0;
}

}  // namespace hfrac::command
