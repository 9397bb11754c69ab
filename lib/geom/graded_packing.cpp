// SPDX-License-Identifier: BSD-3-Clause
// Packings whose discs are fine where a fracture goes and coarser outwards (options/grading.hpp).
//
// Places: the box is halved again and again, across its longer side, where its parts hold as many discs as the integral of 1 / R^2 says,
// until each part holds one. That is what the jittered lattice of a uniform packing is for a density that varies: no
// clusters and no voids to begin with. Radii: the uniform packing's spread, times the mean radius R at each place. Relaxed loosely,
// discs have moved a little; they get the R of where they are now, are relaxed again, and so on; the last relaxation is the packing's own.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geom/packing.hpp"

namespace hfrac {
namespace {

constexpr double loose = 3e-2;  // residual of all relaxations but the last
constexpr int loose_rounds = 3;

struct Box {
  double left, right, low, high;
};

// Integral of 1 / R^2: sums over the squares of a grid, the density the same all over each.
class Density {
 public:
  Density(const PackingOptions& o) {
    const double squares = std::clamp(10.0 * static_cast<double>(o.count), 1e4, 1e6);
    const double side = std::sqrt(o.width * o.height / squares);
    columns_ = static_cast<std::size_t>(std::ceil(o.width / side));
    rows_ = static_cast<std::size_t>(std::ceil(o.height / side));
    wide_ = o.width / static_cast<double>(columns_);
    high_ = o.height / static_cast<double>(rows_);
    sums_.assign((columns_ + 1) * (rows_ + 1), 0.0);
    for (std::size_t row = 0; row < rows_; ++row) {
      double of_row = 0.0;
      for (std::size_t column = 0; column < columns_; ++column) {
        const double radius = o.sizes.at(
            {(static_cast<double>(column) + 0.5) * wide_, (static_cast<double>(row) + 0.5) * high_});
        of_row += wide_ * high_ / (radius * radius);
        sums_[(row + 1) * (columns_ + 1) + column + 1] = sums_[row * (columns_ + 1) + column + 1] + of_row;
      }
    }
  }
  [[nodiscard]] double of(const Box& b) const {
    return below(b.right, b.high) - below(b.left, b.high) - below(b.right, b.low) + below(b.left, b.low);
  }

 private:
  [[nodiscard]] double below(double x, double y) const {
    const double u = std::clamp(x / wide_, 0.0, static_cast<double>(columns_)),
                 v = std::clamp(y / high_, 0.0, static_cast<double>(rows_));
    const auto column = std::min(static_cast<std::size_t>(u), columns_ - 1),
               row = std::min(static_cast<std::size_t>(v), rows_ - 1);
    const double s = u - static_cast<double>(column), t = v - static_cast<double>(row);
    const double* at = &sums_[row * (columns_ + 1) + column];
    return (1.0 - t) * ((1.0 - s) * at[0] + s * at[1]) +
           t * ((1.0 - s) * at[columns_ + 1] + s * at[columns_ + 2]);
  }

  std::size_t columns_ = 0, rows_ = 0;
  double wide_ = 0.0, high_ = 0.0;
  std::vector<double> sums_;
};

// Puts `count` discs into a box.
void place(const Density& density, const Box& box, std::int64_t count, Random& random, Packing& p) {
  const double width = box.right - box.left, height = box.high - box.low;
  if (count == 1) {
    p.x.push_back(box.left + (0.1 + 0.8 * random.uniform()) * width);
    p.y.push_back(box.low + (0.1 + 0.8 * random.uniform()) * height);
    return;
  }
  constexpr int halvings = 50;
  const std::int64_t first = count / 2;
  const double wanted = density.of(box) * static_cast<double>(first) / static_cast<double>(count);
  const bool upright = width >= height;  // the cut
  double from = upright ? box.left : box.low, to = upright ? box.right : box.high;
  Box one = box, other = box;
  for (int k = 0; k < halvings; ++k) {
    const double cut = 0.5 * (from + to);
    (upright ? one.right : one.high) = (upright ? other.left : other.low) = cut;
    (density.of(one) < wanted ? from : to) = cut;
  }
  place(density, one, first, random, p);
  place(density, other, count - first, random, p);
}

// Radii in the proportions given, by the mean radius at each place, as many as fill the box.
void size_by_place(const PackingOptions& o, const Array<double>& proportion, Packing& p) {
  double solid = 0.0;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    p.radius[i] = proportion[i] * o.sizes.at({p.x[i], p.y[i]});
    solid += std::numbers::pi * p.radius[i] * p.radius[i];
  }
  const double scale = std::sqrt((1.0 - o.porosity) * o.width * o.height / solid);
  for (double& r : p.radius) r *= scale;
  p.sizes = o.sizes;
  p.sizes.fine *= scale;
  p.sizes.growth *= scale;
  p.mean_radius = p.sizes.fine;
}

}  // namespace

Packing pack_graded(const PackingOptions& o, const std::function<bool(double)>& progress, Workers* workers) {
  Random random(o.seed);
  Packing p;
  p.radius = spread_radii(o, o.count, o.width * o.height, random);
  const double mean =
      std::accumulate(p.radius.begin(), p.radius.end(), 0.0) / static_cast<double>(p.radius.size());
  for (double& r : p.radius) r /= mean;
  place(Density(o), {0.0, o.width, 0.0, o.height}, o.count, random, p);
  renumber(p);
  const Array<double> proportion = p.radius;
  bool stop = false;
  PackingOptions now = o;
  for (int round = 0; round <= loose_rounds && !stop; ++round) {
    const bool last = round == loose_rounds;
    const double before = 0.1 * round, share = last ? 1.0 - before : 0.1;
    now.residual = last ? o.residual : std::max(loose, o.residual);
    size_by_place(o, proportion, p);
    relax_packing(
        now, p, [&](double done) { return stop = progress && progress(before + share * done); }, workers);
  }
  renumber(p);
  return p;
}

}  // namespace hfrac
