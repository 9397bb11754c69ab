// SPDX-License-Identifier: BSD-3-Clause
// Several cycles in one pass over the model: the list of temporal_blocking.hpp, worked off.
#include <new>

#include "solid/explicit_solver.hpp"

namespace hfrac {

void ExplicitSolver::set_blocking(const BlockingShape& shape) {
  blocking_ = {};
  if (shape.cycles > 1) blocking_ = plan_blocking(plan_, assembly_, network_, shape);
  tile_done_ = std::vector<std::atomic<std::int32_t>>(blocking_.empty() ? 0 : plan_.tiles.size());
  part_done_ = std::vector<std::atomic<std::int32_t>>(tile_done_.size());
}

// Walls under servo control, non-bonded contacts and facets know of discs far apart in every cycle.
bool ExplicitSolver::may_block() const {
  return !blocking_.empty() && !fragments_.kept() && boundary_.acts_disc_by_disc() && non_bonded_.empty() &&
         !facets_.active();
}

void ExplicitSolver::run_blocked(std::int64_t cycles, std::vector<Found>& found) {
  // Pores that keep their pressure push, and that is all.
  const bool pores_answer = arrays_.with_pressure != 0 && arrays_.undrained != 0;
  for (std::int64_t part = 0; arrays_.with_pressure != 0 && !pores_answer && part < arrays_.tile_count;
       ++part)
    kernels_.cross_domains(arrays_, part);
  const bool walls = boundary_.reacts();
  if (walls) boundary_.cycle(assembly_, arrays_.step, options_.stepping_safety, arrays_.damping);
  for (auto* done : {&tile_done_, &part_done_}) {
    for (auto& number : *done) number.store(0, std::memory_order_relaxed);
  }
  next_task_.store(0, std::memory_order_relaxed);
  const auto in_list = static_cast<std::int64_t>(blocking_.tasks.size());
  const std::int64_t sweeps = (cycles + blocking_.cycles - 1) / blocking_.cycles;
  const auto finish = [](std::atomic<std::int32_t>& done, std::int32_t cycle) {
    done.store(cycle, std::memory_order_release);
    done.notify_all();
  };
  const std::function<void(int)> task = [&](int worker) {
    const auto w = static_cast<std::size_t>(worker);
    for (;;) {
      const auto at = next_task_.fetch_add(1, std::memory_order_relaxed);
      if (at >= sweeps * in_list) return;
      const TemporalBlocking::Task& next = blocking_.tasks[static_cast<std::size_t>(at % in_list)];
      const auto cycle =
          static_cast<std::int32_t>(at / in_list) * blocking_.cycles + next.cycle;  // of the batch
      if (cycle > cycles) continue;
      // What was not done for want of memory is not waited for: the batch goes on to its end, and then the step fails.
      const auto do_one = [&](auto&& part) {
        try {
          part();
        } catch (const std::bad_alloc&) {
          no_memory_ = true;
        }
      };
      if (next.item < 0) {
        const std::int32_t part = ~next.item;
        for (auto k = blocking_.part_start[part]; k < blocking_.part_start[part + 1]; ++k)
          workers_.wait_for(tile_done_[blocking_.part_tile[k]], cycle - 1);
        do_one([&] { take_pairs(part, total_cycles_ + cycle - 1, found[w]); });
        if (pores_answer) kernels_.cross_domains(arrays_, part);
        finish(part_done_[part], cycle);
      } else {
        const std::int32_t tile = next.item;
        for (auto k = blocking_.tile_start[tile]; k < blocking_.tile_start[tile + 1]; ++k)
          workers_.wait_for(part_done_[blocking_.tile_part[k]], cycle);
        if (walls) boundary_.press(assembly_, plan_.tiles[tile].first_disc, plan_.tiles[tile].last_disc);
        do_one([&] { take_tile(tile, total_cycles_ + cycle - 1, scratch_[w].data(), found[w]); });
        finish(tile_done_[tile], cycle);
      }
    }
  };
  workers_.run(task);
  total_cycles_ += cycles;
}

}  // namespace hfrac
