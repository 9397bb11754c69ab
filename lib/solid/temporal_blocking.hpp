// SPDX-License-Identifier: BSD-3-Clause
// In which order several cycles in a row go through memory (temporal blocking).
//
// One cycle after the other, a model that no cache holds comes from memory once in every cycle. But a tile can do cycle t as soon
// as the tiles around it have done t - 1; the rest of the model need not have. So a front sweeps over the model: where it comes,
// tiles do cycle 1, some way behind it cycle 2, and so on to the last; what lies between is in the cache still. Nothing is done
// twice, and every sum is made in the order of tiles.hpp, so results have the same bits as one cycle at a time. (The wavefront of
// Wellein, Hager, Zeiser, Wittmann and Fehske 2009; here over tiles of irregular shape, with what waits for what worked out once.)
//
// Tiles are shared out in regions, a front in each, one for each worker: a core keeps a tile from one cycle to the next, and from
// one sweep to the next what its own cache holds. The front goes up and down through strips as wide as the cache allows. What has
// to be done stands in one list, tiles and parts across tiles, each after all that it needs, whoever does that. A worker goes through
// the list and does what is of its region. Where that has to wait for another worker for long, who may have lost its core, it does
// what it can of the other's meanwhile.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include "core/array.hpp"
#include "core/workers.hpp"
#include "model/assembly.hpp"
#include "solid/tiles.hpp"

namespace hfrac {

struct TemporalBlocking {
  struct Task {
    std::int32_t item;   // a tile, or ~part across tiles
    std::int32_t cycle;  // 1 to `cycles`
    std::int32_t region;
  };
  std::int32_t cycles = 0, regions = 1;
  std::vector<Task> tasks;
  // Tiles that a part across tiles touches, parts that touch a tile.
  std::vector<std::int32_t> part_start, part_tile, tile_start, tile_part;

  [[nodiscard]] bool empty() const { return tasks.empty(); }
};

// Whether workers, each with its part of so many tiles, had better do several cycles in one sweep. Where the part is not many times a
// core's own cache, one cycle after the other finds tiles sooner than memory would be asked (docs/performance.md).
bool is_worth_blocking(std::int64_t tiles, int workers);

struct BlockingShape {
  std::int32_t cycles;  // in one sweep
  std::int32_t width;   // of a strip, in tiles
  std::int32_t front;   // tiles a front takes at a time
};

// 3 cycles keep some 80 tiles of a region in use, 13 MB. More find no room in a cache that others use too (docs/performance.md).
constexpr BlockingShape blocking_shape{3, 8, 4};

TemporalBlocking plan_blocking(const TilePlan& plan, const Assembly& assembly, const Network& network,
                               const BlockingShape& shape, std::int32_t regions);

// A batch of cycles worked off by the list.
class BlockedBatch {
 public:
  void use(TemporalBlocking blocking);
  [[nodiscard]] bool empty() const { return blocking_.empty(); }
  void begin(std::int64_t cycles);
  // Inside a task of the team. `item(item, cycle)` does one, of cycle 1 to `cycles`; it must not throw.
  template <class Item>
  void work(const Workers& team, int worker, const Item& item);

 private:
  using Done = std::atomic<std::int32_t>;
  struct alignas(64) Place {
    std::atomic<std::int64_t> at{0};
  };
  struct Wait {
    const Done* of = nullptr;  // none: nothing is missing
    std::int32_t at_least = 0;
  };

  [[nodiscard]] std::int64_t in_list() const { return static_cast<std::int64_t>(blocking_.tasks.size()); }
  [[nodiscard]] std::int32_t cycle_at(std::int64_t at) const;
  [[nodiscard]] bool is_of(int worker, const Workers& team, std::int64_t at) const;
  [[nodiscard]] Wait missing(std::int64_t at) const;
  bool claim(std::int64_t at);
  template <class Item>
  void take(std::int64_t at, const Item& item);
  template <class Item>
  bool help(const Workers& team, int worker, const Item& item);

  TemporalBlocking blocking_;                // empty: one cycle at a time
  std::vector<Done> tile_done_, part_done_;  // cycles of the batch
  std::vector<Done> claimed_;                // by place in the list: sweeps
  std::vector<Place> place_;                 // of each worker, in the list sweep by sweep
  std::int64_t cycles_ = 0, length_ = 0;     // of the batch; of the list, all sweeps
};

template <class Item>
void BlockedBatch::take(std::int64_t at, const Item& item) {
  const auto& task = blocking_.tasks[static_cast<std::size_t>(at % in_list())];
  const auto cycle = cycle_at(at);
  item(task.item, cycle);
  Done& done = task.item < 0 ? part_done_[~task.item] : tile_done_[task.item];
  done.store(cycle, std::memory_order_release);
  done.notify_all();
}

// Does one item of another worker's that is ready and that nobody has begun; false if it finds none not far ahead of them.
template <class Item>
bool BlockedBatch::help(const Workers& team, int worker, const Item& item) {
  constexpr int looked_at = 256;
  for (int other = 0; other < team.active(); ++other) {
    if (other == worker) continue;
    const auto from = place_[static_cast<std::size_t>(other)].at.load(std::memory_order_relaxed);
    for (auto at = from; at < std::min(length_, from + looked_at); ++at) {
      if (!is_of(other, team, at) || missing(at).of != nullptr || !claim(at)) continue;
      take(at, item);
      return true;
    }
  }
  return false;
}

template <class Item>
void BlockedBatch::work(const Workers& team, int worker, const Item& item) {
  auto& place = place_[static_cast<std::size_t>(worker)].at;
  for (std::int64_t at = 0; at < length_; ++at) {
    if (!is_of(worker, team, at)) continue;
    place.store(at, std::memory_order_relaxed);
    if (!claim(at)) continue;
    for (Wait wait = missing(at); wait.of != nullptr; wait = missing(at)) {
      if (!team.comes_soon(*wait.of, wait.at_least) && !help(team, worker, item))
        team.wait_for(*wait.of, wait.at_least);
    }
    take(at, item);
  }
  place.store(length_, std::memory_order_relaxed);
  while (help(team, worker, item)) {
  }
}

}  // namespace hfrac
