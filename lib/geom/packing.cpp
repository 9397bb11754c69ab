// SPDX-License-Identifier: BSD-3-Clause
#include "geom/packing.hpp"

#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/random.hpp"
#include "geom/cell_grid.hpp"
#include "geom/hilbert.hpp"

namespace hfrac {
namespace {

// Pairs that may touch before some disc has moved half the skin.
class NeighbourList {
 public:
  NeighbourList(const Array<double>& radius, double skin) : radius_(radius), skin_(skin) {}

  void refresh(const Array<double>& x, const Array<double>& y) {
    if (!moved_too_far(x, y)) return;
    x_ = x;
    y_ = y;
    const double largest = *std::max_element(radius_.begin(), radius_.end());
    const CellGrid grid(x, y, 2.0 * largest + skin_);
    const auto n = static_cast<std::int32_t>(x.size());
    start.assign(x.size() + 1, 0);
    other.clear();
    for (std::int32_t i = 0; i < n; ++i) {
      grid.near(x[i], y[i], radius_[i] + largest + skin_, [&](std::int32_t j) {
        if (j <= i) return;
        const double dx = x[j] - x[i], dy = y[j] - y[i], reach = radius_[i] + radius_[j] + skin_;
        if (dx * dx + dy * dy < reach * reach) other.push_back(j);
      });
      start[i + 1] = static_cast<std::int32_t>(other.size());
    }
  }

  std::vector<std::int32_t> start, other;

 private:
  [[nodiscard]] bool moved_too_far(const Array<double>& x, const Array<double>& y) const {
    if (x_.empty()) return true;
    const double limit = 0.25 * skin_ * skin_;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double dx = x[i] - x_[i], dy = y[i] - y_[i];
      if (dx * dx + dy * dy > limit) return true;
    }
    return false;
  }

  const Array<double>& radius_;
  double skin_;
  Array<double> x_, y_;
};

struct Overlaps {
  double mean_force = 0.0;  // mean of all contact forces (stiffness 1: mean overlap)
  double mean_unbalanced = 0.0;
};

// Forces of overlapping discs and walls, stiffness 1.
Overlaps overlap_forces(const PackingOptions& box, const Packing& p, const NeighbourList& list,
                        Array<double>& fx, Array<double>& fy) {
  const std::size_t n = p.x.size();
  std::fill(fx.begin(), fx.end(), 0.0);
  std::fill(fy.begin(), fy.end(), 0.0);
  double sum = 0.0;
  std::int64_t contacts = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double fxi = 0.0, fyi = 0.0;
    const double xi = p.x[i], yi = p.y[i], ri = p.radius[i];
    for (auto k = list.start[i]; k < list.start[i + 1]; ++k) {
      const auto j = list.other[k];
      const double dx = p.x[j] - xi, dy = p.y[j] - yi, reach = ri + p.radius[j];
      const double d2 = dx * dx + dy * dy;
      if (d2 >= reach * reach) continue;
      const double d = std::sqrt(d2), overlap = reach - d, scale = overlap / std::max(d, 1e-300);
      fxi -= scale * dx;
      fyi -= scale * dy;
      fx[j] += scale * dx;
      fy[j] += scale * dy;
      sum += overlap;
      ++contacts;
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
  for (std::size_t i = 0; i < n; ++i) result.mean_unbalanced += std::sqrt(fx[i] * fx[i] + fy[i] * fy[i]);
  result.mean_unbalanced /= static_cast<double>(n);
  return result;
}

// FIRE (Bitzek, Koskinen, Gähler, Moseler and Gumbsch 2006) with their parameters; unit masses.
void relax(const PackingOptions& box, Packing& p, const std::function<bool(double)>& progress) {
  const std::size_t n = p.x.size();
  Array<double> fx(n), fy(n), vx(n, 0.0), vy(n, 0.0);
  NeighbourList list(p.radius, 0.4 * p.mean_radius);
  constexpr double step_max = 0.55, grow = 1.1, shrink = 0.5, mixing_start = 0.1, mixing_decay = 0.99;
  constexpr int patience = 5;
  constexpr std::int64_t most = 200000;
  double step = 0.1, mixing = mixing_start;
  int downhill = 0;
  double first = 0.0, done = 0.0;
  for (std::int64_t iteration = 0;; ++iteration) {
    list.refresh(p.x, p.y);
    const Overlaps now = overlap_forces(box, p, list, fx, fy);
    p.residual = now.mean_force > 0.0 ? now.mean_unbalanced / now.mean_force : 0.0;
    p.mean_overlap = now.mean_force / p.mean_radius;
    // Below the jamming density all overlaps vanish: that is at rest too.
    if (p.residual <= box.residual || p.mean_overlap < 1e-6) return;
    if (iteration == most) {
      throw Error(ErrorKind::model,
                  "the packing did not relax below packing.residual = " + std::to_string(box.residual) +
                      " (reached " + std::to_string(p.residual) +
                      "); raise packing.residual or lower packing.porosity");
    }
    // The residual falls by fits and starts; what was reached once is what counts as done.
    if (iteration == 0) first = std::max(p.residual, 10.0 * box.residual);
    done = std::clamp(std::log(first / p.residual) / std::log(first / box.residual), done, 1.0);
    if (progress && iteration % 50 == 0 && progress(done)) return;
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
      p.x[i] += step * vx[i];
      p.y[i] += step * vy[i];
    }
  }
}

}  // namespace

std::vector<std::int32_t> hilbert_order(const Array<double>& x, const Array<double>& y) {
  const std::size_t n = x.size();
  std::vector<std::int32_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  if (n == 0) return order;
  const auto [x_low, x_high] = std::minmax_element(x.begin(), x.end());
  const auto [y_low, y_high] = std::minmax_element(y.begin(), y.end());
  const double scale = 65535.0 / std::max({*x_high - *x_low, *y_high - *y_low, 1e-300});
  std::vector<std::uint32_t> place(n);
  for (std::size_t i = 0; i < n; ++i) {
    place[i] = hilbert_index(static_cast<std::uint32_t>((x[i] - *x_low) * scale),
                             static_cast<std::uint32_t>((y[i] - *y_low) * scale));
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t a, std::int32_t b) { return place[a] < place[b]; });
  return order;
}

Packing pack_discs(const PackingOptions& options, const std::function<bool(double)>& progress) {
  const auto n = static_cast<std::size_t>(options.count);
  Random random(options.seed);
  Packing p;

  // Radii evenly spaced over the range, not drawn: two seeds then differ in arrangement only.
  p.radius.resize(n);
  double area = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    p.radius[i] =
        1.0 + (options.radius_ratio - 1.0) * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    area += 3.14159265358979323846 * p.radius[i] * p.radius[i];
  }
  const double scale = std::sqrt((1.0 - options.porosity) * options.width * options.height / area);
  for (double& r : p.radius) r *= scale;
  shuffle(p.radius, random);
  p.mean_radius = std::accumulate(p.radius.begin(), p.radius.end(), 0.0) / static_cast<double>(n);

  // A lattice with about one site a disc; the sites left over are spread at random.
  const double pitch = std::sqrt(options.width * options.height / static_cast<double>(n));
  const auto columns = static_cast<std::int64_t>(std::ceil(options.width / pitch));
  const auto rows = (options.count + columns - 1) / columns;
  std::vector<std::int64_t> sites(static_cast<std::size_t>(columns * rows));
  std::iota(sites.begin(), sites.end(), 0);
  shuffle(sites, random);
  sites.resize(n);
  std::sort(sites.begin(), sites.end());
  p.x.resize(n);
  p.y.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t row_number = sites[i] / columns;
    const auto column = static_cast<double>(sites[i] % columns), row = static_cast<double>(row_number);
    p.x[i] = (column + 0.1 + 0.8 * random.uniform()) * options.width / static_cast<double>(columns);
    p.y[i] = (row + 0.1 + 0.8 * random.uniform()) * options.height / static_cast<double>(rows);
  }

  const auto renumber = [&p, n] {
    const auto order = hilbert_order(p.x, p.y);
    const auto apply = [&](Array<double>& values) {
      Array<double> sorted(n);
      for (std::size_t i = 0; i < n; ++i) sorted[i] = values[order[i]];
      values.swap(sorted);
    };
    apply(p.x);
    apply(p.y);
    apply(p.radius);
  };
  renumber();
  relax(options, p, progress);
  renumber();
  return p;
}

}  // namespace hfrac
