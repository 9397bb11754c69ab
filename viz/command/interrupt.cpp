// SPDX-License-Identifier: BSD-3-Clause
// sig_atomic_t is all that a handler may touch safely.
#include "command/interrupt.hpp"

#include <csignal>

namespace hfrac::command {
namespace {

volatile std::sig_atomic_t interrupt_flag = 0;

extern "C" void raise_flag(int) {
  interrupt_flag = 1;
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = raise_flag;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() {
  return interrupt_flag != 0;
}

}  // namespace hfrac::command
