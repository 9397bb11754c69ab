// SPDX-License-Identifier: BSD-3-Clause
// Which of the compiled instruction sets this processor runs: "avx512", "avx2", "baseline". Found out once, never changes; the
// library does not read the environment. All give the same bits.
#pragma once

namespace hfrac {

// Whether the set of that name was compiled and this processor runs it.
bool has_instruction_set(const char* name) noexcept;

// The widest of them.
const char* widest_instruction_set() noexcept;

}  // namespace hfrac
