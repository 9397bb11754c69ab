// SPDX-License-Identifier: BSD-3-Clause
// What several cycles in one pass bring (lib/solid/temporal_blocking.hpp), on the sheet.
//
//     bench_blocking N WORKERS CYCLES:WIDTH:FRONT...
//
// One line a shape: how many tiles come from memory per tile and cycle, by a model of caches of 8, 16 and 32 MB that keep what was
// used last; then million bond updates a second, the best of several segments, the shapes taking turns; then how many times the
// work patches would do; then whether the state has the bits of the first shape. 1:1:1 is single cycles.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "sheet_model.hpp"

using namespace hfrac;

namespace {

constexpr std::int64_t cycles_a_segment = 40;

// By the clock, or by processor time for one worker.
double now(int workers) {
  timespec t{};
  clock_gettime(workers == 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// Tiles fetched per tile and cycle if the `room` used last stay.
double fetched(const TemporalBlocking& blocking, std::size_t tiles, std::size_t room) {
  std::list<std::int32_t> kept;
  std::vector<std::list<std::int32_t>::iterator> at(tiles, kept.end());
  std::int64_t misses = 0, uses = 0;
  const auto use = [&](std::int32_t tile) {
    auto& place = at[static_cast<std::size_t>(tile)];
    if (place != kept.end()) {
      kept.splice(kept.begin(), kept, place);
      return;
    }
    ++misses;
    if (kept.size() == room) {
      at[static_cast<std::size_t>(kept.back())] = kept.end();
      kept.pop_back();
    }
    kept.push_front(tile);
    place = kept.begin();
  };
  // Of a tile that only a block of bonds looks at little comes along; it is left out.
  for (int round = 0; round < 2; ++round) {
    misses = uses = 0;
    for (const auto& task : blocking.tasks) {
      if (task.item < 0) continue;
      ++uses;
      use(task.item);
    }
  }
  return static_cast<double>(misses) / static_cast<double>(uses);
}

// The other way to do several cycles at once: patches that each repeat what their neighbours do around them. How many times the
// work a patch of width x width tiles in the middle would do: its last cycle needs the one before of all tiles that share a part
// across tiles with it, and so on.
double patch_work(const TemporalBlocking& blocking, const TilePlan& plan, const Assembly& a,
                  const BlockingShape& shape) {
  const auto tiles = plan.tiles.size();
  const double middle_x = 0.5 * *std::max_element(a.x.begin(), a.x.end()),
               middle_y = 0.5 * *std::max_element(a.y.begin(), a.y.end());
  std::vector<std::pair<double, std::size_t>> away;
  for (std::size_t t = 0; t < tiles; ++t) {
    const auto disc = static_cast<std::size_t>((plan.tiles[t].first_disc + plan.tiles[t].last_disc) / 2);
    away.emplace_back(std::max(std::abs(a.x[disc] - middle_x), std::abs(a.y[disc] - middle_y)), t);
  }
  std::sort(away.begin(), away.end());
  std::vector<char> in(tiles, 0);
  const auto patch =
      std::min(tiles, static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.width));
  for (std::size_t k = 0; k < patch; ++k) in[away[k].second] = 1;
  std::int64_t done = 0;
  for (int cycle = shape.cycles; cycle >= 1; --cycle) {
    done += std::count(in.begin(), in.end(), 1);
    const auto inside = in;
    for (std::size_t part = 0; part < tiles; ++part) {
      const auto first = blocking.part_tile.begin() + blocking.part_start[part],
                 last = blocking.part_tile.begin() + blocking.part_start[part + 1];
      if (std::any_of(first, last, [&](std::int32_t t) { return inside[static_cast<std::size_t>(t)] != 0; }))
        std::for_each(first, last, [&](std::int32_t t) { in[static_cast<std::size_t>(t)] = 1; });
    }
  }
  return static_cast<double>(done) / static_cast<double>(static_cast<std::int64_t>(patch) * shape.cycles);
}

std::uint64_t bits(const Assembly& a) {
  Hash hash;
  for (const auto* values : {&a.ux, &a.uy, &a.rotation, &a.vx, &a.vy, &a.spin, &a.slip})
    hash.add_all(*values);
  return hash.value();
}

struct Contender {
  BlockingShape shape;
  std::unique_ptr<Boundary> boundary;
  std::unique_ptr<ExplicitSolver> solver;
  double best = 1e300;
  std::uint64_t state = 0;
};

void run(std::int64_t count, int worker_count, std::vector<Contender>& contenders) {
  const Options options = bench::sheet_options(ContactMode::parallel);
  bench::Sheet sheet(count, options);
  Assembly& a = sheet.assembly;
  Workers workers(worker_count);
  for (auto& c : contenders) {
    c.boundary = std::make_unique<Boundary>(sheet.model, options);
    c.solver = std::make_unique<ExplicitSolver>(sheet.model, *c.boundary, options, workers);
    c.solver->set_blocking(c.shape);
    c.solver->use_real_masses();
  }
  CrackLog cracks;
  const double start = now(worker_count);
  for (int round = 0; round < 3 || (round < 12 && now(worker_count) - start < 40.0); ++round) {
    for (auto& c : contenders) {
      if (round == 0) {
        for (auto* values : {&a.ux, &a.uy, &a.rotation, &a.spin, &a.slip})
          std::fill(values->begin(), values->end(), 0.0);
        sheet.stir();
      }
      const double at = now(worker_count);
      c.solver->run(cycles_a_segment, cracks);
      c.best = std::min(c.best, (now(worker_count) - at) / cycles_a_segment);
      if (round == 0) c.state = bits(a);
    }
  }
  const TilePlan plan = plan_tiles(a, sheet.network, false, false);
  const double tile_bytes = 160e3;
  for (const auto& c : contenders) {
    const TemporalBlocking blocking = plan_blocking(plan, a, sheet.network, c.shape, worker_count);
    std::printf(
        "%d:%d:%d tiles fetched %.2f %.2f %.2f | %.1f million bond updates/s | patches instead: %.1f times "
        "the work | %s\n",
        c.shape.cycles, c.shape.width, c.shape.front,
        fetched(blocking, plan.tiles.size(), static_cast<std::size_t>(8e6 / tile_bytes)),
        fetched(blocking, plan.tiles.size(), static_cast<std::size_t>(16e6 / tile_bytes)),
        fetched(blocking, plan.tiles.size(), static_cast<std::size_t>(32e6 / tile_bytes)),
        1e-6 * static_cast<double>(a.bond_count()) / c.best, patch_work(blocking, plan, a, c.shape),
        c.state == contenders.front().state ? "same bits" : "OTHER BITS");
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t count = argc > 1 ? std::atoll(argv[1]) : 0;
  const int workers = argc > 2 ? std::atoi(argv[2]) : 0;
  std::vector<Contender> contenders;
  for (int k = 3; k < argc; ++k) {
    Contender& c = contenders.emplace_back();
    if (std::sscanf(argv[k], "%d:%d:%d", &c.shape.cycles, &c.shape.width, &c.shape.front) != 3)
      contenders.clear();
  }
  if (count < 16 || count > 100000000 || workers < 1 || workers > 256 || contenders.empty()) {
    std::fprintf(stderr,
                 "usage: bench_blocking N WORKERS CYCLES:WIDTH:FRONT...   the first is what others are "
                 "compared with\n");
    return 2;
  }
  try {
    run(count, workers, contenders);
  } catch (const Error& error) {
    std::fprintf(stderr, "bench_blocking: %s\n", error.what());
    return 1;
  }
  return 0;
}
