// SPDX-License-Identifier: BSD-3-Clause
#include "geom/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geom/cell_grid.hpp"

namespace hfrac {
namespace {

// To the nearest image of a periodic box; a step of at most one box does.
double nearest_image(double distance, double side) {
  if (distance > 0.5 * side) return distance - side;
  return distance < -0.5 * side ? distance + side : distance;
}

// Pairs that may touch before some disc has moved half the skin.
class NeighbourList {
 public:
  NeighbourList(const RelaxationBox& box, const Array<double>& radius, double skin)
      : box_(box), radius_(radius), skin_(skin) {}

  void refresh(Array<double>& x, Array<double>& y) {
    if (!moved_too_far(x, y)) return;
    if (box_.periodic) wrap(x, y);
    x_ = x;
    y_ = y;
    const double largest = *std::max_element(radius_.begin(), radius_.end());
    const CellGrid grid(x, y, 2.0 * largest + skin_);
    const auto n = static_cast<std::int32_t>(x.size());
    start.assign(x.size() + 1, 0);
    other.clear();
    for (std::int32_t i = 0; i < n; ++i) {
      const double reach_i = radius_[i] + largest + skin_;
      const auto take = [&](std::int32_t j) {
        if (j <= i) return;
        const Vec2 d = between(x, y, i, j);
        const double reach = radius_[i] + radius_[j] + skin_;
        if (d.x * d.x + d.y * d.y < reach * reach) other.push_back(j);
      };
      if (box_.periodic && near_side(x[i], y[i], reach_i)) {
        take_images(grid, x[i], y[i], reach_i, take);
      } else {
        grid.near(x[i], y[i], reach_i, take);
      }
      start[i + 1] = static_cast<std::int32_t>(other.size());
    }
  }

  // From disc i to (the nearest image of) disc j.
  [[nodiscard]] Vec2 between(const Array<double>& x, const Array<double>& y, std::size_t i,
                             std::size_t j) const {
    Vec2 d{x[j] - x[i], y[j] - y[i]};
    if (box_.periodic) d = {nearest_image(d.x, box_.width), nearest_image(d.y, box_.height)};
    return d;
  }

  std::vector<std::int32_t> start, other;

 private:
  void wrap(Array<double>& x, Array<double>& y) const {
    for (auto& v : x) v -= box_.width * std::floor(v / box_.width);
    for (auto& v : y) v -= box_.height * std::floor(v / box_.height);
  }
  [[nodiscard]] bool near_side(double x, double y, double reach) const {
    return x < reach || x > box_.width - reach || y < reach || y > box_.height - reach;
  }
  // Cells around the point and around its images; each partner once, in ascending order.
  template <class Take>
  void take_images(const CellGrid& grid, double x, double y, double reach, Take&& take) {
    around_.clear();
    for (const double shift_y : {-box_.height, 0.0, box_.height}) {
      if (y + shift_y < -reach || y + shift_y > box_.height + reach) continue;
      for (const double shift_x : {-box_.width, 0.0, box_.width}) {
        if (x + shift_x < -reach || x + shift_x > box_.width + reach) continue;
        grid.near(x + shift_x, y + shift_y, reach, [this](std::int32_t j) { around_.push_back(j); });
      }
    }
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
    for (const auto j : around_) take(j);
  }
  [[nodiscard]] bool moved_too_far(const Array<double>& x, const Array<double>& y) const {
    if (x_.empty()) return true;
    const double limit = 0.25 * skin_ * skin_;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double dx = x[i] - x_[i], dy = y[i] - y_[i];
      if (dx * dx + dy * dy > limit) return true;
    }
    return false;
  }

  const RelaxationBox& box_;
  const Array<double>& radius_;
  double skin_;
  Array<double> x_, y_;
  std::vector<std::int32_t> around_;
};

struct Overlaps {
  double mean_force = 0.0;  // mean of all contact forces (stiffness 1: mean overlap)
  double mean_unbalanced = 0.0;
};

// Forces of overlapping discs and walls, stiffness 1.
Overlaps overlap_forces(const RelaxationBox& box, const Array<double>& radius, const Array<double>& x,
                        const Array<double>& y, const std::vector<char>& held, const NeighbourList& list,
                        Array<double>& fx, Array<double>& fy) {
  const std::size_t n = x.size();
  std::fill(fx.begin(), fx.end(), 0.0);
  std::fill(fy.begin(), fy.end(), 0.0);
  double sum = 0.0;
  std::int64_t contacts = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double fxi = 0.0, fyi = 0.0;
    const double xi = x[i], yi = y[i], ri = radius[i];
    for (auto k = list.start[i]; k < list.start[i + 1]; ++k) {
      const auto j = list.other[k];
      const Vec2 d = list.between(x, y, i, static_cast<std::size_t>(j));
      const double reach = ri + radius[j], d2 = d.x * d.x + d.y * d.y;
      if (d2 >= reach * reach) continue;
      const double distance = std::sqrt(d2), overlap = reach - distance,
                   scale = overlap / std::max(distance, 1e-300);
      fxi -= scale * d.x;
      fyi -= scale * d.y;
      fx[j] += scale * d.x;
      fy[j] += scale * d.y;
      sum += overlap;
      ++contacts;
    }
    if (box.periodic) {
      fx[i] += fxi;
      fy[i] += fyi;
      continue;
    }
    const double west = ri - xi, east = xi + ri - box.width, south = ri - yi, north = yi + ri - box.height;
    for (const double overlap : {west, east, south, north}) {
      if (overlap > 0.0) {
        sum += overlap;
        ++contacts;
      }
    }
    fx[i] += fxi + std::max(0.0, west) - std::max(0.0, east);
    fy[i] += fyi + std::max(0.0, south) - std::max(0.0, north);
  }
  Overlaps result;
  result.mean_force = contacts > 0 ? sum / static_cast<double>(contacts) : 0.0;
  std::size_t moving = n;
  if (!held.empty()) {
    moving = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (held[i] != 0) {
        fx[i] = fy[i] = 0.0;
      } else {
        ++moving;
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) result.mean_unbalanced += std::sqrt(fx[i] * fx[i] + fy[i] * fy[i]);
  result.mean_unbalanced /= static_cast<double>(std::max<std::size_t>(1, moving));
  return result;
}

}  // namespace

RelaxationReport relax_overlaps(const RelaxationBox& box, const Array<double>& radius, Array<double>& x,
                                Array<double>& y, const std::vector<char>& held, double residual,
                                std::int64_t most, const std::function<bool(double)>& progress) {
  const std::size_t n = x.size();
  const double mean_radius = std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(n);
  Array<double> fx(n), fy(n), vx(n, 0.0), vy(n, 0.0);
  NeighbourList list(box, radius, 0.4 * mean_radius);
  constexpr double step_max = 0.55, grow = 1.1, shrink = 0.5, mixing_start = 0.1, mixing_decay = 0.99;
  constexpr int patience = 5;
  double step = 0.1, mixing = mixing_start;
  int downhill = 0;
  double first = 0.0, done = 0.0;
  RelaxationReport report;
  for (;; ++report.iterations) {
    list.refresh(x, y);
    const Overlaps now = overlap_forces(box, radius, x, y, held, list, fx, fy);
    report.residual = now.mean_force > 0.0 ? now.mean_unbalanced / now.mean_force : 0.0;
    report.mean_overlap = now.mean_force / mean_radius;
    // Below the jamming density all overlaps vanish: that is at rest too.
    report.at_rest = report.residual <= residual || report.mean_overlap < 1e-6;
    if (report.at_rest || report.iterations == most) return report;
    // The residual falls by fits and starts; what was reached once is what counts as done.
    if (report.iterations == 0) first = std::max(report.residual, 10.0 * residual);
    done = std::clamp(std::log(first / report.residual) / std::log(first / residual), done, 1.0);
    if (progress && report.iterations % 50 == 0 && progress(done)) return report;
    double power = 0.0, f2 = 0.0, v2 = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      power += fx[i] * vx[i] + fy[i] * vy[i];
      f2 += fx[i] * fx[i] + fy[i] * fy[i];
      v2 += vx[i] * vx[i] + vy[i] * vy[i];
    }
    double keep = 1.0, turn = 0.0;
    if (power > 0.0) {
      keep = 1.0 - mixing;
      turn = mixing * std::sqrt(v2 / std::max(f2, 1e-300));
      if (++downhill > patience) {
        step = std::min(step * grow, step_max);
        mixing *= mixing_decay;
      }
    } else {
      keep = 0.0;
      step *= shrink;
      mixing = mixing_start;
      downhill = 0;
    }
    for (std::size_t i = 0; i < n; ++i) {
      vx[i] = keep * vx[i] + (turn + step) * fx[i];
      vy[i] = keep * vy[i] + (turn + step) * fy[i];
      x[i] += step * vx[i];
      y[i] += step * vy[i];
    }
  }
}

}  // namespace hfrac
