// SPDX-License-Identifier: BSD-3-Clause
// Texts that come from outside.
#pragma once

#include <string>
#include <string_view>

namespace hfrac::capi {

// Whether `text` is UTF-8 as the Unicode standard defines it: no overlong forms, no surrogates, nothing above
// U+10FFFF.
bool is_utf8(std::string_view text) noexcept;

// `text` fit for the middle of a one-line message: control characters and bytes that are not UTF-8 become
// '?', what is longer than `limit` bytes is cut.
std::string printable(std::string_view text, std::size_t limit = 80);

}  // namespace hfrac::capi
