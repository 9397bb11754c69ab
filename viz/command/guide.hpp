// SPDX-License-Identifier: BSD-3-Clause
// Where the user guide explains what a refusal speaks of.
#pragma once

#include <string>
#include <string_view>

namespace hfrac::command {

/** "docs/user-guide.md#fluid" of a sentence that names fluid.viscosity; the first key in it counts. Empty if it names none. */
std::string guide_place(std::string_view sentence);

}  // namespace hfrac::command
