// SPDX-License-Identifier: BSD-3-Clause
// Packings for millions of discs: bricks side by side.
//
// One brick is packed with opposite sides joined, so that copies of it fit each other. Copies alone would repeat every
// weak spot of the rock on a grid. So there are several kinds of brick: each keeps the discs near the brick's sides (the
// frame, which is what neighbours touch) and has the discs inside shuffled and relaxed anew. Turned or mirrored bricks
// would do the same for less, but their sides no longer fit. The kinds are laid at random. At last everything is relaxed
// together for a while: against the walls, which cut discs of the outer bricks, and along the seams.
//
// What stays periodic is the frame: about 9 discs in 100 at 5 000 discs a brick repeat with the brick's period.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <numeric>

#include "core/error.hpp"
#include "geom/packing.hpp"
#include "geom/relaxation.hpp"

namespace hfrac {
namespace {

constexpr std::size_t most_kinds = 8;
constexpr std::int64_t most_relaxations = 200000;
// The last relaxation only has seams and sides to mend, but would go on for long-ranged rest that bonding forgets.
constexpr double seam_residual = 3e-3;
constexpr std::int64_t most_seam_iterations = 250;

struct Brick {
  double width, height;
  Packing discs;
};

// Discs that may touch a neighbouring brick's stay: those within a largest diameter of a side, and a little.
std::vector<char> frame_of(const Brick& brick) {
  const Packing& p = brick.discs;
  const double depth = 2.1 * *std::max_element(p.radius.begin(), p.radius.end());
  std::vector<char> held(p.x.size());
  for (std::size_t i = 0; i < held.size(); ++i) {
    const double inside = std::min({p.x[i], brick.width - p.x[i], p.y[i], brick.height - p.y[i]});
    held[i] = inside < depth ? 1 : 0;
  }
  return held;
}

void wrap(Brick& brick) {
  for (auto& x : brick.discs.x) x -= brick.width * std::floor(x / brick.width);
  for (auto& y : brick.discs.y) y -= brick.height * std::floor(y / brick.height);
}

// The same brick with its inside shuffled: radii change places, places are jittered, the frame stands. To be relaxed.
Brick another_kind(const Brick& first, const std::vector<char>& frame, Random& random) {
  Brick brick = first;
  Packing& p = brick.discs;
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (frame[i] == 0) inside.push_back(i);
  }
  Array<double> radii;
  for (const auto i : inside) radii.push_back(p.radius[i]);
  shuffle(radii, random);
  for (std::size_t k = 0; k < inside.size(); ++k) {
    const auto i = inside[k];
    p.radius[i] = radii[k];
    p.x[i] += p.mean_radius * (random.uniform() - 0.5);
    p.y[i] += p.mean_radius * (random.uniform() - 0.5);
  }
  return brick;
}

// Each of those that have not ended to its next report, by one worker.
void go_on(std::vector<Relaxation>& relaxations, std::vector<char>& ended, Workers& workers) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  workers.run(
      [&](int) {
        try {
          for (auto k = next++; k < relaxations.size(); k = next++)
            if (ended[k] == 0) ended[k] = relaxations[k].go_on() ? 0 : 1;
        } catch (...) {
          const std::lock_guard lock(failing);
          failure = std::current_exception();
        }
      },
      false);
  if (failure) std::rethrow_exception(failure);
}

// All but the first: each rank some, which it then shows the others, and of those a worker one at a time. All at hand go on together from
// report to report, so that all ranks ask `progress` as often.
void relax_kinds(std::vector<Brick>& kinds, const std::vector<char>& frame, double residual,
                 const std::function<bool(double)>& progress, Workers& workers, const Ranks& ranks) {
  const std::size_t count = kinds.size() - 1;
  const auto owner = [&](std::size_t k) {
    return static_cast<int>((k - 1) % static_cast<std::size_t>(ranks.size()));
  };
  std::vector<Relaxation> mine;
  for (std::size_t k = 1; k <= count; ++k) {
    Packing& p = kinds[k].discs;
    if (owner(k) == ranks.rank())
      mine.emplace_back(RelaxationBox{kinds[k].width, kinds[k].height, true}, p.radius, p.x, p.y, frame,
                        residual, most_relaxations);
  }
  std::vector<char> ended(mine.size(), 0);
  for (;;) {
    go_on(mine, ended, workers);
    if (!ranks.any(std::count(ended.begin(), ended.end(), 0) > 0)) break;
    double done = 0.0;
    for (const auto& relaxation : mine) done += relaxation.done() / static_cast<double>(mine.size());
    if (progress && progress((1.0 + done * static_cast<double>(count)) / static_cast<double>(count + 1)))
      return;
  }
  for (std::size_t k = 1; k <= count; ++k) {
    for (auto* values : {&kinds[k].discs.x, &kinds[k].discs.y})
      ranks.tell(owner(k), values->data(), static_cast<std::int64_t>(values->size()));
    wrap(kinds[k]);
  }
}

}  // namespace

Packing pack_tiled(const PackingOptions& options, const std::function<bool(double)>& progress,
                   Workers* workers, const Ranks& ranks) {
  Random random(options.seed);
  const double bricks =
      std::max(1.0, std::round(static_cast<double>(options.count) / static_cast<double>(options.brick)));
  const auto columns = static_cast<std::int64_t>(
      std::clamp(std::round(std::sqrt(bricks * options.width / options.height)), 1.0, bricks));
  const auto rows =
      static_cast<std::int64_t>(std::max(1.0, std::round(bricks / static_cast<double>(columns))));
  const auto places = static_cast<std::size_t>(columns * rows);
  Brick first{options.width / static_cast<double>(columns), options.height / static_cast<double>(rows), {}};
  const std::int64_t count =
      std::max<std::int64_t>(1, (options.count + columns * rows / 2) / (columns * rows));

  Workers alone(1);
  Workers& team = workers != nullptr ? *workers : alone;
  bool stop = false;
  const std::size_t kind_count = std::min(most_kinds, places);
  const auto watch = [&](double done) { return stop = progress && progress(0.5 * done); };
  first.discs.radius = spread_radii(options, count, first.width * first.height, random);
  first.discs.mean_radius =
      std::accumulate(first.discs.radius.begin(), first.discs.radius.end(), 0.0) / static_cast<double>(count);
  place_on_lattice(first.width, first.height, random, first.discs);
  relax_overlaps(
      {first.width, first.height, true}, first.discs.radius, first.discs.x, first.discs.y, {},
      options.residual, most_relaxations,
      [&](double done) { return watch(done / static_cast<double>(kind_count)); }, &team);
  wrap(first);
  const std::vector<char> frame = frame_of(first);
  std::vector<Brick> kinds{std::move(first)};
  while (kinds.size() < kind_count) kinds.push_back(another_kind(kinds[0], frame, random));
  if (!stop) relax_kinds(kinds, frame, options.residual, watch, team, ranks);

  Packing p;
  p.mean_radius = kinds[0].discs.mean_radius;
  for (auto* values : {&p.x, &p.y, &p.radius}) values->reserve(static_cast<std::size_t>(count) * places);
  for (std::int64_t place = 0; place < columns * rows; ++place) {
    const Brick& brick = kinds[random.below(kinds.size())];
    const std::int64_t row = place / columns, column = place % columns;
    const double x0 = brick.width * static_cast<double>(column), y0 = brick.height * static_cast<double>(row);
    for (std::size_t i = 0; i < brick.discs.x.size(); ++i) {
      p.x.push_back(x0 + brick.discs.x[i]);
      p.y.push_back(y0 + brick.discs.y[i]);
    }
    p.radius.insert(p.radius.end(), brick.discs.radius.begin(), brick.discs.radius.end());
  }
  kinds.clear();
  if (stop) return p;
  const auto report = relax_overlaps(
      {options.width, options.height}, p.radius, p.x, p.y, {}, std::max(options.residual, seam_residual),
      most_seam_iterations, [&](double done) { return progress && progress(0.5 + 0.5 * done); }, &team);
  p.residual = report.residual;
  p.mean_overlap = report.mean_overlap;
  return p;
}

}  // namespace hfrac
