// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text: the shortest one that reads back as the same number, whatever the locale of the host.
#pragma once

#include <cstdint>
#include <string>

namespace hfrac {

// 0.2, 1e12, 2320, nan.
std::string number_text(double value);
std::string number_text(std::int64_t value);
// Three digits, for estimates: 0.816, 1.23e7.
std::string rounded_text(double value);

}  // namespace hfrac
