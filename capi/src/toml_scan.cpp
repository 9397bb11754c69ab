// SPDX-License-Identifier: BSD-3-Clause
#include "toml_scan.hpp"

#include <algorithm>

namespace hfrac::capi {
namespace {

bool is_beyond_ascii(char c) {
  return static_cast<unsigned char>(c) >= 0x80;
}

// Position after the text in quotes that begins at `begin`. One left open ends with its line, or for the kind
// in triple quotes with the file: the parser will refuse it there. A byte that must not stand
// in a text ends it too: for the caller to find.
std::size_t end_of_text(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const bool escapes = quote == '"';
  const bool triple = text.substr(begin, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
  std::size_t at = begin + (triple ? 3 : 1);
  while (at < text.size()) {
    if (is_beyond_ascii(text[at]) && triple) {
      return at;
    } else if (escapes && text[at] == '\\') {
      if (at + 1 < text.size() && is_beyond_ascii(text[at + 1])) return at + 1;
      at += 2;
    } else if (!triple && (text[at] == quote || text[at] == '\n')) {
      return at + 1;
    } else if (triple && text.substr(at, 3) == text.substr(begin, 3)) {
      // Up to two quotes may stand before the closing three.
      at += 3;
      for (int extra = 0; extra < 2 && at < text.size() && text[at] == quote; ++extra) ++at;
      return at;
    } else {
      ++at;
    }
  }
  return text.size();
}

// A text begins a key or a value; elsewhere a quote is a fault, which the parser finds only after it has
// looked at what follows as if it were no text. (Quoted parts of dotted keys are refused too: no key of a
// case file needs quotes.)
bool may_begin_text(std::string_view text, std::size_t at) {
  return at == 0 || std::string_view(" \t\r\n=,[{\xBF").find(text[at - 1]) != std::string_view::npos;
}

}  // namespace

std::size_t line_of_stray_character(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  std::size_t at = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  while (at < text.size()) {
    const char c = text[at];
    const bool quote = c == '"' || c == '\'';
    if (quote ? !may_begin_text(text, at) : is_beyond_ascii(c)) {
      const char* const here = text.data() + at;
      return 1 + static_cast<std::size_t>(std::count(text.data(), here, '\n'));
    }
    if (quote) {
      at = end_of_text(text, at);
    } else if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
    } else {
      ++at;
    }
  }
  return 0;
}

}  // namespace hfrac::capi
