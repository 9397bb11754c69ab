// SPDX-License-Identifier: BSD-3-Clause
#include "command/dfn_traces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace hfrac::command {
namespace {

double cross(double ax, double ay, double bx, double by) {
  return ax * by - ay * bx;
}

/** Distance of a place from a trace [m]. */
double distance(Place place, const Trace& trace) {
  const double dx = trace.to.x - trace.from.x, dy = trace.to.y - trace.from.y;
  const double along = ((place.x - trace.from.x) * dx + (place.y - trace.from.y) * dy) / (dx * dx + dy * dy);
  const double share = std::clamp(along, 0.0, 1.0);
  return std::hypot(place.x - trace.from.x - share * dx, place.y - trace.from.y - share * dy);
}

/** Calls visit(i, j) for every pair of traces whose rectangles, widened by `room` [m], overlap. */
template <class Visit>
void each_near_pair(const std::vector<Trace>& traces, double room, const Visit& visit) {
  const auto low_x = [&](size_t i) { return std::min(traces[i].from.x, traces[i].to.x); };
  const auto high_x = [&](size_t i) { return std::max(traces[i].from.x, traces[i].to.x); };
  const auto low_y = [&](size_t i) { return std::min(traces[i].from.y, traces[i].to.y); };
  const auto high_y = [&](size_t i) { return std::max(traces[i].from.y, traces[i].to.y); };
  std::vector<size_t> order(traces.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return low_x(a) < low_x(b); });
  for (size_t a = 0; a < order.size(); ++a)
    for (size_t b = a + 1; b < order.size() && low_x(order[b]) <= high_x(order[a]) + room; ++b)
      if (low_y(order[b]) <= high_y(order[a]) + room && low_y(order[a]) <= high_y(order[b]) + room)
        visit(order[a], order[b]);
}

}  // namespace

double length_of(const Trace& trace) {
  return std::hypot(trace.to.x - trace.from.x, trace.to.y - trace.from.y);
}

Frame frame_around(const std::vector<Trace>& traces) {
  if (traces.empty()) return {};
  double left = INFINITY, right = -INFINITY, bottom = INFINITY, top = -INFINITY;
  for (const Trace& trace : traces) {
    for (const Place& end : {trace.from, trace.to}) {
      left = std::min(left, end.x);
      right = std::max(right, end.x);
      bottom = std::min(bottom, end.y);
      top = std::max(top, end.y);
    }
  }
  return {left, bottom, right - left, top - bottom};
}

std::optional<Trace> clipped(const Trace& trace, const Frame& frame) {
  double first = 0.0, last = 1.0;  // share of its length at which it comes in and goes out
  const auto cut = [&](double from, double along, double low, double high) {
    if (along == 0.0) {
      if (from < low || from > high) last = -1.0;
      return;
    }
    const double one = (low - from) / along, other = (high - from) / along;
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
  };
  const double dx = trace.to.x - trace.from.x, dy = trace.to.y - trace.from.y;
  cut(trace.from.x, dx, frame.left, frame.left + frame.width);
  cut(trace.from.y, dy, frame.bottom, frame.bottom + frame.height);
  if (!(first < last)) return std::nullopt;
  const auto at = [&](double share) { return Place{trace.from.x + share * dx, trace.from.y + share * dy}; };
  return Trace{at(first), at(last), trace.set};
}

std::optional<double> meeting(const Trace& one, const Trace& other) {
  const double ax = one.to.x - one.from.x, ay = one.to.y - one.from.y;
  const double bx = other.to.x - other.from.x, by = other.to.y - other.from.y;
  const double wx = other.from.x - one.from.x, wy = other.from.y - one.from.y;
  const double turn = cross(ax, ay, bx, by);
  if (turn == 0.0) return std::nullopt;  // parallel
  const double share = cross(wx, wy, bx, by) / turn, its = cross(wx, wy, ax, ay) / turn;
  if (share < 0.0 || share > 1.0 || its < 0.0 || its > 1.0) return std::nullopt;
  return share;
}

Description describe(const std::vector<Trace>& traces, double touching) {
  Description d;
  d.count = static_cast<int64_t>(traces.size());
  if (traces.empty()) return d;
  std::vector<double> lengths;
  double x = 0.0, y = 0.0;
  for (const Trace& trace : traces) {
    lengths.push_back(length_of(trace));
    const double twice = 2.0 * std::atan2(trace.to.y - trace.from.y, trace.to.x - trace.from.x);
    x += lengths.back() * std::cos(twice);
    y += lengths.back() * std::sin(twice);
  }
  std::sort(lengths.begin(), lengths.end());
  d.length = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  d.shortest = lengths.front();
  d.longest = lengths.back();
  d.mean = d.length / static_cast<double>(d.count);
  d.median = 0.5 * (lengths[(lengths.size() - 1) / 2] + lengths[lengths.size() / 2]);
  d.direction = std::fmod(0.5 * std::atan2(y, x) + std::numbers::pi, std::numbers::pi);
  d.alignment = std::hypot(x, y) / d.length;
  std::vector<std::array<bool, 2>> on_another(traces.size(), {false, false});
  each_near_pair(traces, touching, [&](size_t i, size_t j) {
    bool ends = false;
    for (const auto& [own, other] : {std::pair{i, j}, std::pair{j, i}}) {
      for (const size_t end : {size_t{0}, size_t{1}}) {
        const Place place = end == 0 ? traces[own].from : traces[own].to;
        if (distance(place, traces[other]) > touching) continue;
        on_another[own][end] = true;
        ends = true;
      }
    }
    if (!ends && meeting(traces[i], traces[j])) ++d.crossings;
  });
  for (const auto& ends : on_another) d.t_ends += (ends[0] ? 1 : 0) + (ends[1] ? 1 : 0);
  return d;
}

}  // namespace hfrac::command
