// SPDX-License-Identifier: BSD-3-Clause
#include "solid/blocked_batch.hpp"

#include <utility>

namespace hfrac {

void BlockedBatch::use(TemporalBlocking blocking) {
  blocking_ = std::move(blocking);
  const auto tiles = blocking_.empty() ? 0 : blocking_.tile_start.size() - 1;
  tile_done_ = std::vector<Done>(tiles);
  part_done_ = std::vector<Done>(tiles);
  claimed_ = std::vector<Done>(blocking_.tasks.size());
  place_ = std::vector<Place>(static_cast<std::size_t>(blocking_.regions));
}

void BlockedBatch::begin(std::int64_t cycles) {
  for (auto* of : {&tile_done_, &part_done_, &claimed_}) {
    for (auto& number : *of) number.store(0, std::memory_order_relaxed);
  }
  for (auto& place : place_) place.at.store(0, std::memory_order_relaxed);
  cycles_ = cycles;
  length_ = (cycles + blocking_.cycles - 1) / blocking_.cycles * in_list();
}

// Of the batch; more than it has: nothing is to be done there.
std::int32_t BlockedBatch::cycle_at(std::int64_t at) const {
  return static_cast<std::int32_t>(at / in_list()) * blocking_.cycles +
         blocking_.tasks[static_cast<std::size_t>(at % in_list())].cycle;
}

bool BlockedBatch::is_of(int worker, const Workers& team, std::int64_t at) const {
  const auto region = blocking_.tasks[static_cast<std::size_t>(at % in_list())].region;
  return region * team.active() / blocking_.regions == worker && cycle_at(at) <= cycles_;
}

BlockedBatch::Wait BlockedBatch::missing(std::int64_t at) const {
  const auto& task = blocking_.tasks[static_cast<std::size_t>(at % in_list())];
  const auto of_tile = task.item >= 0;
  const auto item = static_cast<std::size_t>(of_tile ? task.item : ~task.item);
  const auto& start = of_tile ? blocking_.tile_start : blocking_.part_start;
  const auto& needed = of_tile ? blocking_.tile_part : blocking_.part_tile;
  const auto& done = of_tile ? part_done_ : tile_done_;
  const auto at_least = of_tile ? cycle_at(at) : cycle_at(at) - 1;
  for (auto k = start[item]; k < start[item + 1]; ++k) {
    const Done& one = done[static_cast<std::size_t>(needed[static_cast<std::size_t>(k)])];
    if (one.load(std::memory_order_acquire) < at_least) return {&one, at_least};
  }
  return {};
}

// Whoever gets true does it.
bool BlockedBatch::claim(std::int64_t at) {
  auto sweep = static_cast<std::int32_t>(at / in_list());
  return claimed_[static_cast<std::size_t>(at % in_list())].compare_exchange_strong(
      sweep, sweep + 1, std::memory_order_relaxed);
}

}  // namespace hfrac
