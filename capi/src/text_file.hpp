// SPDX-License-Identifier: BSD-3-Clause
// Reading a small text file whole, or refusing at once.
#pragma once

#include <string>

namespace hfrac::capi {

// The text of a case file. Refuses with Error(case_file) what is not a regular file, is above 1 MiB, holds a
// byte 0 or a line above 4096 bytes, before more than that is read: a path to a device, a pipe or a huge file
// costs nothing.
std::string read_text_file(const std::string& path);

}  // namespace hfrac::capi
