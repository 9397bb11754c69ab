// SPDX-License-Identifier: BSD-3-Clause
// Texts of files: base64, numbers, and texts of unknown origin made safe to show.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hfrac::run {

/** Letters that so many bytes take as base64 (RFC 4648), with the signs that fill the last four up. */
constexpr size_t base64_length(size_t bytes) {
  return (bytes + 2) / 3 * 4;
}

/** Writes them to `to`, where only the signs that fill up, '=', have to stand already. */
void put_base64(char* to, std::span<const std::byte> bytes);

/** Adds `bytes` to `text` as base64. */
void append_base64(std::string& text, std::span<const std::byte> bytes);

/** One or more runs of base64 behind each other, with white space between the letters. Nothing if it is none. */
std::optional<std::vector<uint8_t>> from_base64(std::string_view text);

/** A number that is the whole word, by the rules of C whatever the host's locale. */
template <class Number>
std::optional<Number> number_in(std::string_view word) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/** The text as a terminal, SVG and HTML can show it: control characters (but line ends and tabs) and bytes that are no UTF-8
 * become U+FFFD. Titles come from case files and may hold anything. */
std::string printable(std::string_view text);

/** printable, with &, <, > and " as entities of XML and HTML. */
std::string escaped(std::string_view text);

}  // namespace hfrac::run
