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

// Pairs that may touch before some disc has moved half the skin, first[k] < second[k], in ascending order of the first. One flat
// list: a loop over each disc's own few would end at a number of turns no processor foresees.
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
    first.clear();
    second.clear();
    for (std::int32_t i = 0; i < n; ++i) {
      const double reach_i = radius_[i] + largest + skin_;
      const auto take = [&](std::int32_t j) {
        if (j <= i) return;
        const Vec2 d = between(x, y, i, j);
        const double reach = radius_[i] + radius_[j] + skin_;
        if (d.x * d.x + d.y * d.y >= reach * reach) return;
        first.push_back(i);
        second.push_back(j);
      };
      if (box_.periodic && near_side(x[i], y[i], reach_i)) {
        take_images(grid, x[i], y[i], reach_i, take);
      } else {
        grid.near(x[i], y[i], reach_i, take);
      }
    }
  }

  // From disc i to (the nearest image of) disc j.
  [[nodiscard]] Vec2 between(const Array<double>& x, const Array<double>& y, std::size_t i,
                             std::size_t j) const {
    Vec2 d{x[j] - x[i], y[j] - y[i]};
    if (box_.periodic) d = {nearest_image(d.x, box_.width), nearest_image(d.y, box_.height)};
    return d;
  }

  std::vector<std::int32_t> first, second;

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
    int far = 0;  // no early end, so that it runs in vectors
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double dx = x[i] - x_[i], dy = y[i] - y_[i];
      far |= dx * dx + dy * dy > limit ? 1 : 0;
    }
    return far != 0;
  }

  const RelaxationBox& box_;
  const Array<double>& radius_;
  double skin_;
  Array<double> x_, y_;
  std::vector<std::int32_t> around_;
};

// Of all discs, stiffness 1. A disc's own pairs and those it is second in are added up apart.
struct Forces {
  explicit Forces(std::size_t n) : x(n, 0.0), y(n, 0.0), own_x(n, 0.0), own_y(n, 0.0) {}
  Array<double> x, y, own_x, own_y;
};

struct Contacts {
  double overlap = 0.0;  // sum of all, which is that of their forces
  std::int64_t count = 0;
};

// What overlapping discs push each other with. Nothing branches on whether two touch: that would be guessed wrong too often.
template <bool periodic>
Contacts push_discs(const Array<double>& radius, const Array<double>& x, const Array<double>& y,
                    const NeighbourList& list, Forces& f) {
  double sum = 0.0, count = 0.0;
  double* __restrict own_x = f.own_x.data();
  double* __restrict own_y = f.own_y.data();
  double* __restrict fx = f.x.data();
  double* __restrict fy = f.y.data();
  for (std::size_t k = 0; k < list.first.size(); ++k) {
    const auto i = static_cast<std::size_t>(list.first[k]), j = static_cast<std::size_t>(list.second[k]);
    const Vec2 d = periodic ? list.between(x, y, i, j) : Vec2{x[j] - x[i], y[j] - y[i]};
    const double reach = radius[i] + radius[j], d2 = d.x * d.x + d.y * d.y, distance = std::sqrt(d2);
    const double touch = d2 < reach * reach ? 1.0 : 0.0;
    const double overlap = touch * (reach - distance), scale = overlap / std::max(distance, 1e-300);
    own_x[i] -= scale * d.x;
    own_y[i] -= scale * d.y;
    fx[j] += scale * d.x;
    fy[j] += scale * d.y;
    sum += overlap;
    count += touch;
  }
  return {sum, static_cast<std::int64_t>(count)};
}

// What the box's walls push disc i with.
Vec2 push_of_walls(const RelaxationBox& box, double x, double y, double radius, Vec2 force,
                   Contacts& contacts) {
  const double west = radius - x, east = x + radius - box.width, south = radius - y,
               north = y + radius - box.height;
  if (std::max(std::max(west, east), std::max(south, north)) <= 0.0) return force;
  for (const double overlap : {west, east, south, north}) {
    if (overlap <= 0.0) continue;
    contacts.overlap += overlap;
    ++contacts.count;
  }
  return {force.x + std::max(0.0, west) - std::max(0.0, east),
          force.y + std::max(0.0, south) - std::max(0.0, north)};
}

struct Sums {
  double unbalanced = 0.0;                 // of the sizes of forces
  double power = 0.0, f2 = 0.0, v2 = 0.0;  // force times velocity, squares of both
};

}  // namespace

RelaxationReport relax_overlaps(const RelaxationBox& box, const Array<double>& radius, Array<double>& x,
                                Array<double>& y, const std::vector<char>& held, double residual,
                                std::int64_t most, const std::function<bool(double)>& progress) {
  const std::size_t n = x.size();
  const double mean_radius = std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(n);
  const auto moving = static_cast<double>(std::max<std::int64_t>(
      1,
      static_cast<std::int64_t>(n) - std::count_if(held.begin(), held.end(), [](char h) { return h != 0; })));
  Forces f(n);
  Array<double> vx(n, 0.0), vy(n, 0.0);
  NeighbourList list(box, radius, 0.4 * mean_radius);
  constexpr double step_max = 0.55, grow = 1.1, shrink = 0.5, mixing_start = 0.1, mixing_decay = 0.99;
  constexpr int patience = 5;
  double step = 0.1, mixing = mixing_start;
  int downhill = 0;
  double first = 0.0, done = 0.0;
  RelaxationReport report;
  for (;; ++report.iterations) {
    list.refresh(x, y);
    Contacts contacts =
        box.periodic ? push_discs<true>(radius, x, y, list, f) : push_discs<false>(radius, x, y, list, f);
    Sums sums;
    for (std::size_t i = 0; i < n; ++i) {
      Vec2 force{f.own_x[i], f.own_y[i]};
      if (!box.periodic) force = push_of_walls(box, x[i], y[i], radius[i], force, contacts);
      const bool stays = !held.empty() && held[i] != 0;
      const double fx = f.x[i] = stays ? 0.0 : f.x[i] + force.x, fy = f.y[i] = stays ? 0.0 : f.y[i] + force.y;
      sums.unbalanced += std::sqrt(fx * fx + fy * fy);
      sums.power += fx * vx[i] + fy * vy[i];
      sums.f2 += fx * fx + fy * fy;
      sums.v2 += vx[i] * vx[i] + vy[i] * vy[i];
    }
    const double mean_force =
        contacts.count > 0 ? contacts.overlap / static_cast<double>(contacts.count) : 0.0;
    report.residual = mean_force > 0.0 ? sums.unbalanced / moving / mean_force : 0.0;
    report.mean_overlap = mean_force / mean_radius;
    // Below the jamming density all overlaps vanish: that is at rest too.
    report.at_rest = report.residual <= residual || report.mean_overlap < 1e-6;
    if (report.at_rest || report.iterations == most) return report;
    // The residual falls by fits and starts; what was reached once is what counts as done.
    if (report.iterations == 0) first = std::max(report.residual, 10.0 * residual);
    done = std::clamp(std::log(first / report.residual) / std::log(first / residual), done, 1.0);
    if (progress && report.iterations % 50 == 0 && progress(done)) return report;
    double keep = 1.0, turn = 0.0;
    if (sums.power > 0.0) {
      keep = 1.0 - mixing;
      turn = mixing * std::sqrt(sums.v2 / std::max(sums.f2, 1e-300));
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
      vx[i] = keep * vx[i] + (turn + step) * f.x[i];
      vy[i] = keep * vy[i] + (turn + step) * f.y[i];
      x[i] += step * vx[i];
      y[i] += step * vy[i];
      f.x[i] = f.y[i] = f.own_x[i] = f.own_y[i] = 0.0;
    }
  }
}

}  // namespace hfrac
