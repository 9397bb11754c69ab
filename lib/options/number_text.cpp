// SPDX-License-Identifier: BSD-3-Clause
#include "options/number_text.hpp"

#include <charconv>

namespace hfrac {
namespace {

// C writes exponents as e+09 and e-07; 1e9 and 1e-7 say the same.
std::string with_short_exponent(const std::string& text) {
  const auto e = text.find('e');
  if (e == std::string::npos) return text;
  const bool negative = text[e + 1] == '-';
  const auto digits = text.find_first_not_of("+-0", e + 1);
  return text.substr(0, e + 1) + (negative ? "-" : "") + text.substr(digits);
}

}  // namespace

std::string number_text(double value) {
  char buffer[32];
  return with_short_exponent({buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr});
}

std::string rounded_text(double value) {
  char buffer[32];
  return with_short_exponent(
      {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 3).ptr});
}

std::string number_text(std::int64_t value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

}  // namespace hfrac
