// SPDX-License-Identifier: BSD-3-Clause
// Text that has to keep to a width, on pages of either kind.
#pragma once

#include <algorithm>
#include <string>

#include "page.h"

namespace hfrac::viz {

// The text, cut and ended by "..." if it is wider than `width`.
template <class AnyPage>
std::string fitted(const AnyPage& page, const std::string& content, const TextStyle& style, double width) {
  if (page.text_width(content, style) <= width) return content;
  std::string cut = content;
  while (!cut.empty()) {
    // One whole UTF-8 letter less.
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80) cut.pop_back();
    if (!cut.empty()) cut.pop_back();
    if (page.text_width(cut + "...", style) <= width) break;
  }
  return cut + "...";
}

// The style for a title: a long one is set smaller, before it is cut.
template <class AnyPage>
TextStyle title_style(const AnyPage& page, const std::string& title, TextStyle style, double width) {
  style.size *= std::clamp(width / std::max(1.0, page.text_width(title, style)), 0.7, 1.0);
  return style;
}

}  // namespace hfrac::viz
