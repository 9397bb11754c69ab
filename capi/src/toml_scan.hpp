// SPDX-License-Identifier: BSD-3-Clause
// A look at a TOML text before it is parsed.
#pragma once

#include <cstddef>
#include <string_view>

namespace hfrac::capi {

// Line of the first character that toml++ 3.3 must not see, 0 if there is none: a byte outside ASCII that is
// neither in a one-line text (nor right after a backslash there) nor in a comment, and a quote in the middle
// of a word. It would look whether what it finds is a blank, which is undefined behaviour for U+00A1 to
// U+0499 and others. TOML itself allows such bytes in triple quotes, and quotes inside dotted keys; a case
// file has no use for either.
std::size_t line_of_stray_character(std::string_view text);

}  // namespace hfrac::capi
