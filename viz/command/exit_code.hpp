// SPDX-License-Identifier: BSD-3-Clause
// What the program tells the shell.
#pragma once

#include <stdexcept>

namespace hfrac::command {

enum ExitCode : int {
  kGood = 0,
  kRunFailed = 1,  ///< a file could not be written, the solution diverged, memory ran out
  kBadInput = 2,   ///< wrong usage or a bad case file; nothing was written
  kCollapsed =
      3,  ///< the rock fell apart, in the initial equilibration or in a step; steps before it are written
  kInterrupted = 130,  ///< Ctrl-C or a polite kill; what there was is written
};

/** The user asked for something that cannot be done; ends the program with kBadInput. */
class BadInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace hfrac::command
