// SPDX-License-Identifier: BSD-3-Clause
#include "svg_text.h"

#include <charconv>
#include <string_view>

namespace hfrac::viz {
namespace {

// Where the value of `name="..."` is in the tag that starts at `tag`; npos if it has none.
struct Attribute {
  std::size_t first = std::string::npos;
  std::size_t length = 0;
};

Attribute find_attribute(const std::string& text, std::size_t tag, const std::string& name) {
  const std::size_t end = text.find('>', tag);
  const std::size_t found = text.find(" " + name + "=\"", tag);
  if (end == std::string::npos || found == std::string::npos || found > end) return {};
  const std::size_t first = found + name.size() + 3;
  return {first, text.find('"', first) - first};
}

double number_at(const std::string& text, const Attribute& attribute) {
  double value = 0;
  if (attribute.first == std::string::npos) return 0;
  std::from_chars(text.data() + attribute.first, text.data() + attribute.first + attribute.length, value);
  return value;
}

std::string decimal(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

}  // namespace

std::string hexadecimal(Colour colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const int part : {colour.red, colour.green, colour.blue}) {
    text += digits[part / 16];
    text += digits[part % 16];
  }
  return text;
}

std::string mended_svg(const std::string& svg, Colour paper) {
  std::string text = svg;
  const std::size_t root = text.find("<svg ");
  if (root == std::string::npos) return text;
  const double width = number_at(text, find_attribute(text, root, "width"));
  const double height = number_at(text, find_attribute(text, root, "height"));
  const std::string clip = " clip-path=\"";
  for (std::size_t at = text.find(clip); at != std::string::npos; at = text.find(clip, at)) {
    const std::size_t end = text.find('"', at + clip.size());
    if (end == std::string::npos) break;
    text.erase(at, end + 1 - at);
  }
  const std::size_t content = text.find("<g ", root);
  if (content != std::string::npos) {
    text.insert(content, "<rect width=\"100%\" height=\"100%\" fill=\"" + hexadecimal(paper) + "\"/>\n  ");
  }
  text.insert(root + 5, "viewBox=\"0 0 " + decimal(width) + " " + decimal(height) + "\" ");
  return text;
}

}  // namespace hfrac::viz
