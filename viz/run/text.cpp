// SPDX-License-Identifier: BSD-3-Clause
#include "run/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

namespace hfrac::run {
namespace {

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/** Two letters for each value of twelve bits. */
constexpr auto pairs_of_letters = [] {
  std::array<std::array<char, 2>, 4096> pairs{};
  for (unsigned i = 0; i < 4096; ++i) pairs[i] = {letters[i >> 6U], letters[i & 63U]};
  return pairs;
}();

constexpr auto values_of_letters = [] {
  std::array<int16_t, 256> values{};
  values.fill(-1);
  for (size_t i = 0; i < letters.size(); ++i)
    values[static_cast<unsigned char>(letters[i])] = static_cast<int16_t>(i);
  return values;
}();

/** Length of the UTF-8 character at the front of `text`, 0 if there is none (Unicode 15, table 3-7). */
size_t character_length(std::string_view text) {
  const auto at = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = at(0);
  if (first < 0x80) return 1;
  const size_t length = first >= 0xC2 && first < 0xE0   ? 2
                        : first >= 0xE0 && first < 0xF0 ? 3
                        : first >= 0xF0 && first < 0xF5 ? 4
                                                        : 0;
  for (size_t i = 1; i < length; ++i)
    if ((at(i) & 0xC0U) != 0x80) return 0;
  const bool overlong = (first == 0xE0 && at(1) < 0xA0) || (first == 0xF0 && at(1) < 0x90);
  const bool outside = (first == 0xED && at(1) > 0x9F) || (first == 0xF4 && at(1) > 0x8F);
  return overlong || outside ? 0 : length;
}

/** U+0000 to U+001F, U+007F to U+009F, and the two code points that no XML may hold. */
bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return (first < 0x20 && first != '\n' && first != '\t') || first == 0x7F;
  if (character.size() == 2) return first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
  return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
}

}  // namespace

void append_base64(std::string& text, std::span<const std::byte> bytes) {
  const size_t begin = text.size();
  text.resize(begin + base64_length(bytes.size()), '=');
  put_base64(text.data() + begin, bytes);
}

void put_base64(char* place, std::span<const std::byte> bytes) {
  const auto at = [&](size_t i) { return i < bytes.size() ? std::to_integer<unsigned>(bytes[i]) : 0U; };
  size_t i = 0;
  for (; i + 3 <= bytes.size(); i += 3, place += 4) {
    const unsigned group = at(i) << 16U | at(i + 1) << 8U | at(i + 2);
    std::memcpy(place, pairs_of_letters[group >> 12U].data(), 2);
    std::memcpy(place + 2, pairs_of_letters[group & 4095U].data(), 2);
  }
  if (i == bytes.size()) return;
  const unsigned group = at(i) << 16U | at(i + 1) << 8U;
  std::memcpy(place, pairs_of_letters[group >> 12U].data(), 2);
  if (bytes.size() - i == 2) place[2] = pairs_of_letters[group & 4095U][0];
}

// Padding may come in the middle, where runs meet; groups of four letters stand for themselves.
std::optional<std::vector<uint8_t>> from_base64(std::string_view text) {
  std::vector<uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3);
  uint32_t group = 0;
  int count = 0, padding = 0;
  for (const char letter : text) {
    if (std::isspace(static_cast<unsigned char>(letter)) != 0) continue;
    const int value = values_of_letters[static_cast<unsigned char>(letter)];
    if (letter == '=') {
      ++padding;
    } else if (value < 0 || padding > 0) {
      return std::nullopt;
    }
    group = group << 6U | (letter == '=' ? 0U : static_cast<uint32_t>(value));
    if (++count < 4) continue;
    if (padding > 2) return std::nullopt;
    bytes.push_back(static_cast<uint8_t>(group >> 16U));
    if (padding < 2) bytes.push_back(static_cast<uint8_t>(group >> 8U));
    if (padding < 1) bytes.push_back(static_cast<uint8_t>(group));
    group = 0;
    count = padding = 0;
  }
  if (count != 0) return std::nullopt;
  return bytes;
}

std::string printable(std::string_view text) {
  std::string safe;
  while (!text.empty()) {
    const size_t length = character_length(text);
    const auto character = text.substr(0, std::max<size_t>(length, 1));
    safe += length == 0 || is_control(character) ? std::string_view("\xEF\xBF\xBD") : character;
    text.remove_prefix(character.size());
  }
  return safe;
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char letter : printable(text)) {
    switch (letter) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += letter;
    }
  }
  return safe;
}

}  // namespace hfrac::run
