// SPDX-License-Identifier: BSD-3-Clause
// toml++ made safe for files from anyone.
//
// toml++ 3.3 states what its parser expects as assertions, and some of them do not hold for malformed files
// ("[\x1e"). In a debug build that ends the process; with NDEBUG the compiler is told to take them for
// granted, so that such a file leads to undefined behaviour. Here an assertion that fails is an exception in
// every build. To be included by one source file only, as the meaning of toml++'s inline functions depends on
// it.
#pragma once

#include <cassert>
#include <exception>

namespace hfrac::capi {

class TomlFault : public std::exception {};

constexpr void toml_assert(bool holds) {
  if (!holds) throw TomlFault();
}

}  // namespace hfrac::capi

#define TOML_EXCEPTIONS 1
#define TOML_ENABLE_FORMATTERS 0
#define TOML_ASSERT(expr) ::hfrac::capi::toml_assert(static_cast<bool>(expr))
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
