// SPDX-License-Identifier: BSD-3-Clause
// The one exception of the library.
//
// Whoever finds the fault throws it, with a text a user can act on: the value at fault, what is allowed, what
// to change. The C interface turns the kind into a status code; nothing else of an exception leaves the
// library.
#pragma once

#include <stdexcept>
#include <string>

namespace hfrac {

// One for one the error codes of capi/include/hfrac/base.h (HFRAC_ERR_*).
enum class ErrorKind {
  argument,     // NULL, not finite or out of range; nothing has changed
  bad_handle,   // never created, or destroyed
  struct_size,  // not set by the init function, or unknown
  unknown_key,  // no option of that name
  case_file,    // cannot be read or holds an invalid value
  model,        // options valid one by one, but nothing can be built from them together
  diverged,     // the solution left the range of finite numbers; the state is the one before the step
  collapsed,  // the rock fell apart: as it was loaded first, or in a step; the state is the one before the step
  memory,     // out of memory
  busy,       // called from inside a callback of the same simulation
  poisoned,  // an earlier error left the simulation unusable
  exchange,  // another rank of the simulation failed or does not answer
  device,    // the device that computes failed
  file,      // a file cannot be written, cannot be read, or is not what it should be
  internal   // a fault of the library itself
};

class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& text) : std::runtime_error(text), kind_(kind) {}
  ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace hfrac
