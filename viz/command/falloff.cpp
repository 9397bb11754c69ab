// SPDX-License-Identifier: BSD-3-Clause
#include "command/falloff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "command/least_squares.hpp"

namespace hfrac::command {
namespace {

// Slopes are taken over all rows from x / kReach to x kReach, at places a step of kStep apart.
constexpr double kReach = 1.15, kStep = 1.02;
constexpr double kOff = 0.075;     // of the slope of a straight line: more is a departure from it
constexpr double kErrors = 3.0;    // standard deviations that are no departure either
constexpr double kVague = 0.05;    // of the slope: a standard deviation above that tells nothing
constexpr double kStiffer = 0.25;  // of the slope: a rise by less is no stiffening
constexpr std::size_t kMostRows = 20'000;

/** The fall-off over a coordinate that rises with time. */
class Course {
 public:
  Course(std::vector<double> x, const Falloff& falloff)
      : x_(std::move(x)), falloff_(falloff), sums_(x_, falloff.pressure) {}

  std::size_t row_of(double x) const {
    return static_cast<std::size_t>(std::lower_bound(x_.begin(), x_.end(), x) - x_.begin());
  }
  double last() const { return x_.back(); }

  Slopes slopes() const {
    Slopes all;
    for (double x = x_[1] * kReach; x * kReach <= x_.back(); x *= kStep) {
      const std::size_t first = row_of(x / kReach), end = row_of(x * kReach * (1.0 + 1e-12));
      if (end < first + 3) continue;
      const FittedLine line = sums_.line(first, end);
      all.x.push_back(x);
      all.slope.push_back(-line.slope);  // how fast the pressure falls
      // Three of them are as unlikely then as three of a normal distribution, whatever the number of rows (Fisher 1925's expansion of
      // Student's distribution).
      const double freedom = static_cast<double>(end - first) - 2.0;
      all.error.push_back(line.error * (1.0 + 2.5 / freedom + 5.75 / (freedom * freedom)));
    }
    return all;
  }

  /** Through the rows between two places. */
  FittedLine line(double from, double to) const {
    const std::size_t first = row_of(from), end = std::max(row_of(to * (1.0 + 1e-12)), first + 2);
    return sums_.line(std::min(first, x_.size() - 2), std::min(end, x_.size()));
  }

  /** Where the slope changes near `x`. */
  Closure bend(double x, double from, double to) const {
    const Bend found = find_bend(x_, falloff_.pressure, row_of(from), std::min(row_of(to) + 1, x_.size()),
                                 x / 1.35, std::min(x * 1.35, to));
    Closure closure;
    closure.x = found.x;
    closure.pressure = found.y;
    closure.since = since(found.x);
    return closure;
  }

 private:
  /** [s] between the rows on both sides, in proportion. */
  double since(double x) const {
    const std::size_t k = std::clamp<std::size_t>(row_of(x), 1, x_.size() - 1);
    const double share = (x - x_[k - 1]) / (x_[k] - x_[k - 1]);
    return falloff_.since[k - 1] + share * (falloff_.since[k] - falloff_.since[k - 1]);
  }

  std::vector<double> x_;
  const Falloff& falloff_;
  RowSums sums_;
};

/** Means of neighbouring rows, so that a record of any length is read in a moment. */
Falloff fewer_rows(const Falloff& all) {
  const std::size_t together = (all.since.size() + kMostRows - 1) / kMostRows;
  if (together <= 1) return all;
  Falloff fewer{all.injection, {}, {}};
  for (std::size_t first = 0; first < all.since.size(); first += together) {
    const std::size_t end = std::min(first + together, all.since.size());
    double since = 0.0, pressure = 0.0;
    for (std::size_t k = first; k < end; ++k) {
      since += all.since[k];
      pressure += all.pressure[k];
    }
    fewer.since.push_back(since / static_cast<double>(end - first));
    fewer.pressure.push_back(pressure / static_cast<double>(end - first));
  }
  return fewer;
}

/** The straight stretch before closure: first and last place of the slopes. */
struct Stretch {
  std::size_t first = 0, last = 0;
  double slope = 0.0;
};

bool agrees(const Slopes& slopes, std::size_t k, double slope) {
  return std::abs(slopes.slope[k] - slope) <= std::max(kOff * slope, kErrors * slopes.error[k]);
}

/** From the earliest place on from which the slope stays the same until twice that x. */
std::optional<Stretch> straight_stretch(const Course& course, const Slopes& slopes) {
  for (std::size_t first = 0; first < slopes.x.size(); ++first) {
    const double until = 2.0 * slopes.x[first];
    if (until > slopes.x.back()) break;
    const double slope = -course.line(slopes.x[first] / kReach, until * kReach).slope;
    if (slope <= 0.0) continue;
    std::size_t k = first;
    while (k < slopes.x.size() && slopes.x[k] <= until && slopes.error[k] <= kVague * slope &&
           agrees(slopes, k, slope))
      ++k;
    if (k < slopes.x.size() && slopes.x[k] <= until) continue;
    Stretch found{first, k - 1, slope};
    for (; k < slopes.x.size() && agrees(slopes, k, found.slope); ++k) {
      found.last = k;
      found.slope = -course.line(slopes.x[first] / kReach, slopes.x[k] / kReach).slope;
    }
    return found;
  }
  return std::nullopt;
}

/** Whether `is_off` from place `begin` on, until the rows before it count no more. */
template <class Test>
bool stays_off(const Slopes& slopes, std::size_t begin, const Test& is_off) {
  if (begin >= slopes.x.size()) return false;
  const double until = slopes.x[begin] * kReach * kReach;
  if (until > slopes.x.back()) return false;
  for (std::size_t k = begin; k < slopes.x.size() && slopes.x[k] <= until; ++k)
    if (!is_off(k)) return false;
  return true;
}

/** Where, after the straight stretch, the pressure begins to fall faster over G than at the least slope so far. */
void read_closure_by_stiffness(const Course& course, const Stretch& stretch, FalloffReading& reading) {
  const Slopes& slopes = reading.over_g;
  double least = stretch.slope, error = 0.0;
  for (std::size_t k = stretch.last + 1; k < slopes.x.size(); ++k) {
    if (slopes.slope[k] > 0.0 && slopes.slope[k] < least) {
      least = slopes.slope[k];
      error = slopes.error[k];
    }
    const auto rises = [&](std::size_t at) {
      return slopes.slope[at] > (1.0 + kStiffer) * least + kErrors * std::hypot(slopes.error[at], error);
    };
    if (!stays_off(slopes, k, rises)) continue;
    const double near = slopes.x[k];
    reading.by_stiffness = course.bend(near, near / 1.6, std::min(course.last(), near * 1.6));
    return;
  }
}

void read_closure_by_g(const Course& course, FalloffReading& reading) {
  const Slopes& slopes = reading.over_g;
  const auto stretch = slopes.x.empty() ? std::nullopt : straight_stretch(course, slopes);
  if (!stretch) {
    reading.notes.emplace_back(
        "no closure by the G function: G dP/dG has no straight line through the origin over a doubling of G");
    return;
  }
  const FittedLine line = course.line(slopes.x[stretch->first] / kReach, slopes.x[stretch->last] / kReach);
  reading.line = StraightLine{line.at_zero, line.slope};
  read_closure_by_stiffness(course, *stretch, reading);
  const auto falls_below = [&](std::size_t k) {
    return slopes.slope[k] < stretch->slope && !agrees(slopes, k, stretch->slope);
  };
  if (!stays_off(slopes, stretch->last + 1, falls_below)) {
    reading.notes.push_back(fmt::format(
        "no closure by the G function: G dP/dG does not fall below its line for good up to the end of the "
        "fall-off at G = {:.3g}{}",
        course.last(), reading.by_stiffness ? "" : "; it is too short, or the fracture stays open"));
    return;
  }
  const double near = slopes.x[stretch->last + 1];
  const double from = std::max(slopes.x[stretch->first] / kReach, near / 2.0);
  reading.by_g = course.bend(near, from, std::min(course.last(), near * 1.6));
  const FittedLine before = course.line(slopes.x[stretch->first] / kReach, reading.by_g->x);
  reading.line = StraightLine{before.at_zero, before.slope};
}

/** The inflection of pressure over the square root of time: where it falls fastest (Barree, Barree and Craig 2009). */
void read_closure_by_root(const Course& course, FalloffReading& reading) {
  const Slopes& slopes = reading.over_root;
  double lowest = INFINITY, most = 0.0;
  std::size_t top = 0;
  for (std::size_t k = 0; k < slopes.x.size(); ++k) {
    if (slopes.error[k] > kVague * slopes.slope[k]) continue;
    lowest = std::min(lowest, slopes.slope[k]);
    if (slopes.slope[k] - lowest <= most) continue;
    most = slopes.slope[k] - lowest;
    top = k;
  }
  const auto falls = [&](std::size_t k) {
    return slopes.slope[top] - slopes.slope[k] >
           std::max(kOff * slopes.slope[top], kErrors * slopes.error[k]);
  };
  std::size_t after = top;
  while (after < slopes.x.size() && !falls(after)) ++after;
  if (most == 0.0 || after >= slopes.x.size()) {
    reading.notes.emplace_back(
        "no closure by the square root of time: the pressure falls over it ever faster, or ever slower; it "
        "has no "
        "inflection");
    return;
  }
  const double near = slopes.x[top];
  reading.by_root = course.bend(near, near / 1.25, std::min(course.last(), near * 1.25));
}

/** The line through the early fall-off, over G, to shut-in. */
std::optional<double> early_line(const std::vector<double>& g, const Falloff& falloff) {
  constexpr double begin = 0.005, end = 0.05;  // of the injection's time: after the well's own oscillations
  std::vector<double> x, y;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double share = falloff.since[k] / falloff.injection;
    if (share <= 0.0 || share < begin) continue;
    if (share > end && x.size() >= 5) break;
    x.push_back(g[k]);
    y.push_back(falloff.pressure[k]);
  }
  if (x.size() < 5) return std::nullopt;
  return RowSums(x, y).line(0, x.size()).at_zero;
}

}  // namespace

double nolte_g(double since, LeakOff leak_off) {
  const double one = 1.0 + since;
  if (leak_off == LeakOff::little)
    return 16.0 / (3.0 * std::numbers::pi) * (one * std::sqrt(one) - since * std::sqrt(since) - 1.0);
  return 4.0 / std::numbers::pi *
         (one * std::asin(1.0 / std::sqrt(one)) + std::sqrt(since) - 0.5 * std::numbers::pi);
}

FalloffReading read_falloff(const Falloff& all, LeakOff leak_off) {
  FalloffReading reading;
  constexpr std::size_t fewest = 20;
  if (all.since.size() < fewest) {
    reading.notes.push_back(
        fmt::format("the fall-off has {} rows; {} are needed to read it", all.since.size(), fewest));
    return reading;
  }
  const Falloff falloff = fewer_rows(all);
  std::vector<double> g, root;
  for (const double since : falloff.since) {
    g.push_back(nolte_g(since / falloff.injection, leak_off));
    root.push_back(std::sqrt(since));
  }
  reading.isip = early_line(g, falloff);
  const Course over_g(g, falloff), over_root(root, falloff);
  reading.over_g = over_g.slopes();
  reading.over_root = over_root.slopes();
  read_closure_by_g(over_g, reading);
  read_closure_by_root(over_root, reading);
  return reading;
}

}  // namespace hfrac::command
