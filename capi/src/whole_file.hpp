// SPDX-License-Identifier: BSD-3-Clause
// Writing a file so that it is there whole or not at all: aside, synced, renamed.
#pragma once

#include <string>
#include <string_view>

namespace hfrac::capi {

// Throws Error(argument) with the system's reason; an earlier file of that name is then untouched.
void write_whole_file(const std::string& path, std::string_view bytes);

}  // namespace hfrac::capi
