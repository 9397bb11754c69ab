// SPDX-License-Identifier: BSD-3-Clause
#include "html.h"

#include <array>
#include <span>
#include <string_view>

#include "colour.h"
#include "failure.h"
#include "run/text.hpp"

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

std::string data_address(const std::string& kind, const std::string& content) {
  std::string text = "data:" + kind + ";base64,";
  append_base64(text, std::as_bytes(std::span(content)));
  return text;
}

std::string inline_svg(const std::string& svg) {
  const std::size_t root = svg.find("<svg ");
  if (root == std::string::npos) return {};
  std::string text = svg.substr(root);
  replace_all(text, " xmlns=\"http://www.w3.org/2000/svg\"", " role=\"img\"");
  for (const NamedColour& named : chart_colours) {
    const std::string value = hexadecimal(light_palette().*named.colour);
    for (const std::string attribute : {"fill", "stroke"})
      replace_all(text, attribute + "=\"" + value + "\"", attribute + "=\"var(" + named.name + ")\"");
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
