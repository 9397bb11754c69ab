// SPDX-License-Identifier: BSD-3-Clause
// Several cycles in one pass over the model: the list of temporal_blocking.hpp, worked off.
#include <new>

#include "solid/explicit_solver.hpp"

namespace hfrac {

void ExplicitSolver::set_blocking(const BlockingShape& shape) {
  blocked_.use(shape.cycles > 1 ? plan_blocking(plan_, assembly_, network_, shape, workers_.count())
                                : TemporalBlocking{});
}

// Walls under servo control, non-bonded contacts and facets know of discs far apart in every cycle.
bool ExplicitSolver::may_block() const {
  return !blocked_.empty() && !fragments_.kept() && boundary_.acts_disc_by_disc() && non_bonded_.empty() &&
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
  blocked_.begin(cycles);
  const std::function<void(int)> task = [&](int worker) {
    const auto w = static_cast<std::size_t>(worker);
    blocked_.work(workers_, worker, [&](std::int32_t item, std::int32_t cycle) {
      const std::int64_t now = total_cycles_ + cycle - 1;
      // What was not done for want of memory is not waited for: the batch goes on to its end, and then the step fails.
      try {
        if (item < 0) {
          take_pairs(~item, now, found[w]);
        } else {
          if (walls) boundary_.press(assembly_, plan_.tiles[item].first_disc, plan_.tiles[item].last_disc);
          take_tile(item, now, scratch_[w].data(), found[w]);
        }
      } catch (const std::bad_alloc&) {
        no_memory_ = true;
      }
      if (item < 0 && pores_answer) kernels_.cross_domains(arrays_, ~item);
    });
  };
  workers_.run(task);
  total_cycles_ += cycles;
}

}  // namespace hfrac
