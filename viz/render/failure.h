// SPDX-License-Identifier: BSD-3-Clause
// How the renderer reports trouble inside: an exception with the status the C interface returns, or those of files
// (run/files.hpp), which become HFRAC_VIZ_ERR_READ and HFRAC_VIZ_ERR_WRITE.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "hfrac/viz.h"
#include "run/files.hpp"

namespace hfrac::viz {
using namespace hfrac::run;

class Failure : public std::runtime_error {
 public:
  Failure(std::int32_t status, const std::string& text) : std::runtime_error(text), status_(status) {}
  std::int32_t status() const { return status_; }

 private:
  std::int32_t status_;
};

[[noreturn]] inline void fail_drawing(const std::string& text) {
  throw Failure(HFRAC_VIZ_ERR_DRAW, text);
}
[[noreturn]] inline void fail_argument(const std::string& text) {
  throw Failure(HFRAC_ERR_ARGUMENT, text);
}

}  // namespace hfrac::viz
