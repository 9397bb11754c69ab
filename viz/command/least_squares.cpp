// SPDX-License-Identifier: BSD-3-Clause
#include "command/least_squares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hfrac::command {
namespace {

/** y = a + b min(x - c, 0) + e max(x - c, 0) by least squares: a, b, e and what is left. */
struct BentFit {
  double a = 0.0, b = 0.0, e = 0.0, squares = std::numeric_limits<double>::infinity();
};

// Two lines that share their value at c: normal equations of three unknowns, b and e taken out by hand.
BentFit bent_at(const std::vector<double>& x, const std::vector<double>& y, std::size_t first,
                std::size_t end, double c) {
  double n = 0.0, sy = 0.0, yy = 0.0;
  std::array<double, 2> u{}, uu{}, uy{};
  for (std::size_t k = first; k < end; ++k) {
    const std::size_t side = x[k] < c ? 0 : 1;
    const double d = x[k] - c, value = y[k] - y[first];
    n += 1.0;
    sy += value;
    yy += value * value;
    u[side] += d;
    uu[side] += d * d;
    uy[side] += d * value;
  }
  if (uu[0] <= 0.0 || uu[1] <= 0.0) return {};
  const double weight = n - u[0] * u[0] / uu[0] - u[1] * u[1] / uu[1];
  if (weight <= 0.0) return {};
  const double a = (sy - u[0] * uy[0] / uu[0] - u[1] * uy[1] / uu[1]) / weight;
  const double b = (uy[0] - a * u[0]) / uu[0], e = (uy[1] - a * u[1]) / uu[1];
  return {a + y[first], b, e, yy - a * sy - b * uy[0] - e * uy[1]};
}

}  // namespace

RowSums::RowSums(const std::vector<double>& x, const std::vector<double>& y) : sums_(x.size() + 1) {
  if (x.empty()) return;
  x0_ = x[x.size() / 2];
  y0_ = y[y.size() / 2];
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double u = x[k] - x0_, v = y[k] - y0_;
    const Sums& s = sums_[k];
    sums_[k + 1] = {s.x + u, s.y + v, s.xx + u * u, s.xy + u * v, s.yy + v * v};
  }
}

FittedLine RowSums::line(std::size_t first, std::size_t end) const {
  const Sums &a = sums_[first], &b = sums_[end];
  const auto n = static_cast<double>(end - first);
  const double mx = (b.x - a.x) / n, my = (b.y - a.y) / n;
  const double xx = b.xx - a.xx - n * mx * mx, xy = b.xy - a.xy - n * mx * my, yy = b.yy - a.yy - n * my * my;
  FittedLine line;
  line.slope = xx > 0.0 ? xy / xx : 0.0;
  line.squares = std::max(0.0, yy - line.slope * xy);
  line.error = n > 2.0 && xx > 0.0 ? std::sqrt(line.squares / (n - 2.0) / xx)
                                   : std::numeric_limits<double>::infinity();
  line.at_zero = my + y0_ - line.slope * (mx + x0_);
  return line;
}

Bend find_bend(const std::vector<double>& x, const std::vector<double>& y, std::size_t first, std::size_t end,
               double lowest, double highest) {
  Bend best{lowest, y[first], 0.0, 0.0};
  double least = std::numeric_limits<double>::infinity(), low = lowest, high = highest;
  constexpr int places = 60;
  for (int round = 0; round < 3; ++round) {  // the second and third around the best of the one before
    const double part = (high - low) / places;
    for (int i = 0; i <= places; ++i) {
      const double c = low + i * part;
      const BentFit fit = bent_at(x, y, first, end, c);
      if (fit.squares >= least) continue;
      least = fit.squares;
      best = {c, fit.a, fit.b, fit.e};
    }
    low = std::max(lowest, best.x - part);
    high = std::min(highest, best.x + part);
  }
  return best;
}

}  // namespace hfrac::command
