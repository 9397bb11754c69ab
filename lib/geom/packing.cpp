// SPDX-License-Identifier: BSD-3-Clause
#include "geom/packing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/error.hpp"
#include "geom/hilbert.hpp"
#include "geom/relaxation.hpp"
#include "options/options.hpp"

namespace hfrac {
namespace {

constexpr std::int64_t most_iterations = 200000;

double mean_of(const Array<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Discs at random, grown from half their size in stages, loosely relaxed at each (relax_packing() does the last one).
void grow(const PackingOptions& options, Random& random, Packing& p,
          const std::function<bool(double)>& progress, Workers* workers) {
  constexpr int stages = 10;
  constexpr double first_size = 0.5, loose = 3e-2;
  const auto n = static_cast<std::size_t>(options.count);
  p.x.resize(n);
  p.y.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    p.x[i] = options.width * random.uniform();
    p.y[i] = options.height * random.uniform();
  }
  renumber(p);
  Array<double> small(n);
  for (int stage = 0; stage < stages; ++stage) {
    const double size = first_size + (1.0 - first_size) * stage / stages;
    std::transform(p.radius.begin(), p.radius.end(), small.begin(), [&](double r) { return size * r; });
    bool stop = false;
    relax_overlaps(
        {options.width, options.height}, small, p.x, p.y, {}, loose, most_iterations,
        [&](double done) { return stop = progress && progress(0.5 * (stage + done) / stages); }, workers);
    if (stop) return;
  }
}

}  // namespace

void renumber(Packing& p) {
  const auto order = hilbert_order(p.x, p.y);
  Array<double> sorted(p.x.size());
  for (auto* values : {&p.x, &p.y, &p.radius}) {
    for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i] = (*values)[order[i]];
    values->swap(sorted);
  }
}

void relax_packing(const PackingOptions& options, Packing& p, const std::function<bool(double)>& progress,
                   Workers* workers) {
  const auto report = relax_overlaps({options.width, options.height}, p.radius, p.x, p.y, {},
                                     options.residual, most_iterations, progress, workers);
  p.residual = report.residual;
  p.mean_overlap = report.mean_overlap;
  if (report.iterations < most_iterations) return;
  throw Error(ErrorKind::model,
              "the packing did not relax below packing.residual = " + std::to_string(options.residual) +
                  " (reached " + std::to_string(p.residual) +
                  "); raise packing.residual or lower packing.porosity");
}

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

// Evenly spaced over the range, not drawn: two seeds then differ in arrangement only.
Array<double> spread_radii(const PackingOptions& options, std::int64_t count, double area, Random& random) {
  Array<double> radius(static_cast<std::size_t>(count));
  double solid = 0.0;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    radius[i] =
        1.0 + (options.radius_ratio - 1.0) * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    solid += std::numbers::pi * radius[i] * radius[i];
  }
  const double scale = std::sqrt((1.0 - options.porosity) * area / solid);
  for (double& r : radius) r *= scale;
  shuffle(radius, random);
  return radius;
}

// A lattice with about one site a disc; the sites left over are spread at random.
void place_on_lattice(double width, double height, Random& random, Packing& p) {
  const auto n = p.radius.size();
  const double pitch = std::sqrt(width * height / static_cast<double>(n));
  const auto columns = static_cast<std::int64_t>(std::ceil(width / pitch));
  const auto rows = (static_cast<std::int64_t>(n) + columns - 1) / columns;
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
    p.x[i] = (column + 0.1 + 0.8 * random.uniform()) * width / static_cast<double>(columns);
    p.y[i] = (row + 0.1 + 0.8 * random.uniform()) * height / static_cast<double>(rows);
  }
}

namespace {

Packing pack_square(const PackingOptions& o) {
  Packing p;
  const double share = static_cast<double>(o.count) * o.width / o.height;
  const auto columns = std::max<std::int64_t>(2, std::llround(std::sqrt(share)));
  p.mean_radius = 0.5 * o.width / static_cast<double>(columns);
  // As many rows as fit, in the middle.
  const auto rows = static_cast<std::int64_t>(std::floor(0.5 * o.height / p.mean_radius * (1.0 + 1e-12)));
  const double low = 0.5 * o.height - p.mean_radius * static_cast<double>(rows);
  for (std::int64_t row = 0; row < rows; ++row) {
    for (std::int64_t column = 0; column < columns; ++column) {
      p.x.push_back(p.mean_radius * static_cast<double>(2 * column + 1));
      p.y.push_back(low + p.mean_radius * static_cast<double>(2 * row + 1));
      p.radius.push_back(p.mean_radius);
    }
  }
  return p;
}

}  // namespace

PackingOptions packing_options(const Options& options) {
  PackingOptions p;
  p.width = options.model_width;
  p.height = options.model_height;
  p.count = options.packing_disc_count;
  p.radius_ratio = options.packing_radius_ratio;
  p.porosity = options.packing_porosity;
  p.residual = options.packing_residual;
  p.seed = static_cast<std::uint64_t>(options.model_seed);
  p.method = PackingMethod{options.packing_method};
  p.brick = options.packing_brick_discs;
  return p;
}

Packing pack_discs(const PackingOptions& options, const std::function<bool(double)>& progress,
                   Workers* workers, const Ranks& ranks) {
  if (options.method == PackingMethod::tiled) {
    Packing tiled = pack_tiled(options, progress, workers, ranks);
    renumber(tiled);
    return tiled;
  }
  if (options.method == PackingMethod::square) {
    Packing square = pack_square(options);
    renumber(square);
    return square;
  }
  if (options.sizes.graded()) return pack_graded(options, progress, workers);
  Random random(options.seed);
  Packing p;
  p.radius = spread_radii(options, options.count, options.width * options.height, random);
  p.mean_radius = mean_of(p.radius);
  bool stop = false;
  const bool grown = options.method == PackingMethod::growth;
  const auto last_stage = [&](double done) {
    return stop = progress && progress(grown ? 0.5 + 0.5 * done : done);
  };
  if (grown) {
    grow(
        options, random, p, [&](double done) { return stop = progress && progress(done); }, workers);
  } else {
    place_on_lattice(options.width, options.height, random, p);
    renumber(p);
  }
  if (!stop) relax_packing(options, p, last_stage, workers);
  renumber(p);
  return p;
}

}  // namespace hfrac
