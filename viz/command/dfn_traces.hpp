// SPDX-License-Identifier: BSD-3-Clause
// Traces of natural fractures as a map of lines, and how such a map is described.
//
// P20 is the number of traces per area [1/m2], P21 their length per area [1/m] (Dershowitz and Herda 1992). Where two traces pass through
// each other is a crossing (X); an end that lies on another trace is a T end (Manzocchi 2002). Directions have no sense, so their mean is
// taken of doubled angles (Mardia and Jupp 2000).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hfrac::command {

struct Place {
  double x = 0.0, y = 0.0;  ///< [m]
};

struct Trace {
  Place from, to;
  int32_t set = 0;
};

double length_of(const Trace& trace);

/** A rectangle [m]. */
struct Frame {
  double left = 0.0, bottom = 0.0, width = 0.0, height = 0.0;
};

/** The rectangle around all traces. */
Frame frame_around(const std::vector<Trace>& traces);

/** The part of a trace inside a frame (Liang and Barsky 1984); nothing if it has no length there. */
std::optional<Trace> clipped(const Trace& trace, const Frame& frame);

/** Where, as a share of the way along `one`, it passes through `other`; nothing if they do not meet. */
std::optional<double> meeting(const Trace& one, const Trace& other);

struct Description {
  int64_t count = 0;
  double length = 0.0;                   ///< [m] of all
  double shortest = 0.0, longest = 0.0;  ///< [m]
  double mean = 0.0, median = 0.0;       ///< [m] of the lengths
  double direction = 0.0;                ///< [rad] mean, weighted by length, from x, 0 to pi
  double alignment = 0.0;                ///< length of the mean of doubled directions: 0 all ways, 1 parallel
  int64_t crossings = 0, t_ends = 0;     ///< X and T
};

/** `touching` [m]: an end no farther than that from another trace is a T end. */
Description describe(const std::vector<Trace>& traces, double touching);

}  // namespace hfrac::command
