// SPDX-License-Identifier: BSD-3-Clause
#include "rose.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "charts.h"
#include "number_text.h"

namespace hfrac::viz {
namespace {

constexpr double half_turn = std::numbers::pi;

std::vector<Point> wedge(Point centre, double inner, double outer, double from, double to) {
  constexpr int parts = 8;
  std::vector<Point> corners;
  for (int i = 0; i <= parts; ++i) {
    const double angle = from + (to - from) * i / parts;
    corners.push_back({centre.x + outer * std::cos(angle), centre.y - outer * std::sin(angle)});
  }
  for (int i = parts; i >= 0 && inner > 0; --i) {
    const double angle = from + (to - from) * i / parts;
    corners.push_back({centre.x + inner * std::cos(angle), centre.y - inner * std::sin(angle)});
  }
  if (!(inner > 0)) corners.push_back(centre);
  return corners;
}

void put_spokes(ChartPage& page, Point centre, double radius) {
  for (int degrees = 0; degrees < 360; degrees += 30) {
    const double angle = degrees * half_turn / 180;
    const Point rim{centre.x + radius * std::cos(angle), centre.y - radius * std::sin(angle)};
    page.line({centre, rim}, 1.2, palette().grid);
    page.text(centre.x + (radius + 36) * std::cos(angle), centre.y - (radius + 30) * std::sin(angle) + 8,
              std::to_string(degrees) + "\xC2\xB0", {20, palette().ink, false, Align::centre});
  }
}

}  // namespace

void put_ring(ChartPage& page, Point centre, double radius, double thickness, Colour colour) {
  constexpr int parts = 120;
  std::vector<Point> ring;
  for (int i = 0; i <= parts; ++i) {
    const double angle = 2 * half_turn * i / parts;
    ring.push_back({centre.x + radius * std::cos(angle), centre.y - radius * std::sin(angle)});
  }
  page.line(ring, thickness, colour);
}

RoseScale put_rose(ChartPage& page, Point centre, double radius, const RoseBins& bins,
                   const std::vector<Colour>& colours) {
  RoseScale scale;
  const auto sum = [](const std::vector<double>& bin) {
    return std::accumulate(bin.begin(), bin.end(), 0.0);
  };
  double longest = 0;
  for (const auto& bin : bins) longest = std::max(longest, sum(bin));
  if (longest > 0) scale.longest = longest;
  put_spokes(page, centre, radius);
  const double part = half_turn / static_cast<double>(bins.size());
  for (std::size_t i = 0; i < bins.size(); ++i) {
    double metres = 0;
    for (std::size_t kind = 0; kind < bins[i].size(); ++kind) {
      const double inner = radius * metres / scale.longest;
      metres += bins[i][kind];
      const double outer = radius * metres / scale.longest;
      for (const double turn : {0.0, half_turn}) {
        const double from = part * static_cast<double>(i) + turn + 0.012;
        const double to = part * static_cast<double>(i + 1) + turn - 0.012;
        if (outer > inner) page.polygon(wedge(centre, inner, outer, from, to), colours[kind]);
      }
    }
  }
  const std::vector<Tick> rings = round_ticks(0, scale.longest, 4);
  for (const Tick& ring : rings) {
    if (ring.value <= 0) continue;
    put_ring(page, centre, radius * ring.value / scale.longest, 1.4, palette().frame);
  }
  scale.ring = rings.size() > 1 ? rings[1].text : "1";
  return scale;
}

}  // namespace hfrac::viz
