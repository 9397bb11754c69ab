// SPDX-License-Identifier: BSD-3-Clause
// A batch of cycles worked off by the list of temporal_blocking.hpp.
//
// Each worker does what is of its region, in the order of the list, and waits until what an item needs is done. Where another worker
// takes long over that, who may have lost its core, it does what it can of the other's meanwhile. The item that stands first among those
// not done needs nothing that is not done, and whoever has it to do waits for nothing else: so somebody can always go on.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include "core/workers.hpp"
#include "solid/temporal_blocking.hpp"

namespace hfrac {

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
