// SPDX-License-Identifier: BSD-3-Clause
#include "command/specimen_svg.hpp"

#include <fmt/format.h>
#include <hfrac/hfrac.h>

#include <algorithm>
#include <iterator>

namespace hfrac::command {
namespace {

constexpr double page = 900.0, margin = 20.0,
                 heading = 40.0;  // pixels: the longer side of the specimen, around, above
constexpr const char* tension = "#c1272d";
constexpr const char* shear = "#1b5fa8";

std::string plain(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return safe;
}

}  // namespace

std::string specimen_svg(const std::vector<double>& discs, const std::vector<double>& cracks,
                         const std::string& title) {
  double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
  for (std::size_t k = 0; k + 5 <= discs.size(); k += 5) {
    left = std::min(left, discs[k] - discs[k + 2]);
    right = std::max(right, discs[k] + discs[k + 2]);
    low = std::min(low, discs[k + 1] - discs[k + 2]);
    high = std::max(high, discs[k + 1] + discs[k + 2]);
  }
  const double scale = page / std::max(right - left, high - low);
  const auto x = [&](double at) { return margin + scale * (at - left); };
  const auto y = [&](double at) { return heading + scale * (high - at); };
  std::string svg;
  auto out = std::back_inserter(svg);
  const double width = std::max(2.0 * margin + scale * (right - left), 520.0);
  const double height = heading + margin + scale * (high - low);
  fmt::format_to(
      out,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"15\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text x=\"{:.0f}\" y=\"24\">{}; cracks in <tspan fill=\"{}\">tension</tspan>, <tspan "
      "fill=\"{}\">shear</tspan></text>\n<g fill=\"#e8e2d4\" stroke=\"#9d9585\" stroke-width=\"0.4\">\n",
      width, height, margin, plain(title), tension, shear);
  for (std::size_t k = 0; k + 5 <= discs.size(); k += 5)
    fmt::format_to(out, "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\"/>\n", x(discs[k] + discs[k + 3]),
                   y(discs[k + 1] + discs[k + 4]), scale * discs[k + 2]);
  svg += "</g>\n<g stroke-width=\"2\" stroke-linecap=\"round\">\n";
  for (std::size_t k = 0; k + 5 <= cracks.size(); k += 5)
    fmt::format_to(out, "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n",
                   x(cracks[k]), y(cracks[k + 1]), x(cracks[k + 2]), y(cracks[k + 3]),
                   static_cast<int>(cracks[k + 4]) == HFRAC_CRACK_TENSION ? tension : shear);
  svg += "</g>\n</svg>\n";
  return svg;
}

}  // namespace hfrac::command
