// SPDX-License-Identifier: BSD-3-Clause
#include "html.h"

#include <array>
#include <fstream>
#include <sstream>
#include <string_view>

#include "colour.h"
#include "failure.h"
#include "svg_text.h"

namespace hfrac::viz {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

struct NamedColour {
  const char* name;
  Colour Palette::*colour;
};

// The palette's members that occur in charts.
constexpr std::array<NamedColour, 12> chart_colours = {{{"--paper", &Palette::paper},
                                                        {"--ink", &Palette::ink},
                                                        {"--faint", &Palette::faint_ink},
                                                        {"--frame", &Palette::frame},
                                                        {"--grid", &Palette::grid},
                                                        {"--tension", &Palette::tension},
                                                        {"--shear", &Palette::shear},
                                                        {"--well", &Palette::well},
                                                        {"--bond", &Palette::bond},
                                                        {"--water", &Palette::water},
                                                        {"--pull", &Palette::pull},
                                                        {"--push", &Palette::push}}};

}  // namespace

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
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

std::string base64(std::span<const std::uint8_t> bytes) {
  static constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? letters[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

std::string file_content(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return {};
  std::ifstream file(path, std::ios::binary);
  std::stringstream content;
  content << file.rdbuf();
  if (!file) fail_reading("cannot read " + path.string());
  return content.str();
}

std::string data_address(const std::string& kind, const std::string& content) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(content.data());
  return "data:" + kind + ";base64," + base64({bytes, content.size()});
}

std::string inline_svg(const std::string& svg, const std::string& prefix) {
  const std::size_t root = svg.find("<svg ");
  if (root == std::string::npos) return {};
  std::string text = svg.substr(root);
  replace_all(text, " xmlns=\"http://www.w3.org/2000/svg\"", "");
  replace_all(text, " xmlns:xlink=\"http://www.w3.org/1999/xlink\"", "");
  replace_all(text, "<svg viewBox", "<svg role=\"img\" viewBox");
  replace_all(text, "id=\"", "id=\"" + prefix);
  replace_all(text, "url(#", "url(#" + prefix);
  replace_all(text, "href=\"#", "href=\"#" + prefix);
  for (const NamedColour& named : chart_colours) {
    const std::string value = hexadecimal(light_palette().*named.colour);
    for (const char* attribute : {"fill", "stroke"}) {
      replace_all(text, std::string(attribute) + "=\"" + value + "\"",
                  std::string(attribute) + "=\"var(" + named.name + ")\"");
    }
  }
  return text;
}

std::string colour_variables(bool dark) {
  const Palette& colours = dark ? dark_palette() : light_palette();
  std::string text;
  for (const NamedColour& named : chart_colours) {
    text.append(named.name).append(": ").append(hexadecimal(colours.*named.colour)).append("; ");
  }
  return text;
}

std::string name_table(const Rows& rows) {
  std::string text = "<table class=\"names\">\n";
  for (const auto& [name, value] : rows) {
    text.append("<tr><th>").append(escaped(name)).append("</th><td>").append(escaped(value));
    text.append("</td></tr>\n");
  }
  return text + "</table>\n";
}

}  // namespace hfrac::viz
