// SPDX-License-Identifier: BSD-3-Clause
// The workers of all ranks as one team, for arrays that every rank has whole: each does a part and tells the others what they need of it.
//
// Of a rank's workers the first alone talks. Where another rank no longer answers, the task goes on to its end on what there is, in
// silence, and then share() throws: a task ends in any case.
#pragma once

#include <exception>

#include "core/halo.hpp"
#include "core/ranks.hpp"
#include "core/workers.hpp"

namespace hfrac {

class RankTeam {
 public:
  // Without ranks: the workers of one.
  explicit RankTeam(Workers& workers, const Ranks& ranks = {}) : workers_(workers), ranks_(ranks) {}

  [[nodiscard]] const Ranks& ranks() const { return ranks_; }
  [[nodiscard]] Workers& workers() const { return workers_; }

  // One worker of one rank.
  class Member {
   public:
    Member(RankTeam& team, const Workers::Member& worker, bool over_ranks)
        : team_(team), worker_(worker), over_ranks_(over_ranks) {}
    // The same worker in a task that ranks share, or that each does for itself.
    [[nodiscard]] Member among(bool over_ranks) const { return {team_, worker_, over_ranks && over_ranks_}; }
    [[nodiscard]] bool is_over_ranks() const { return over_ranks_; }
    [[nodiscard]] bool is_first() const { return worker_.number == 0; }
    void barrier() const { worker_.barrier(); }

    // Of n items this worker's part of its rank's: ranks get multiples of `grain`, workers of `fine`, which divides it.
    [[nodiscard]] Workers::Range part(std::int64_t n, std::int64_t grain, std::int64_t fine) const {
      if (!over_ranks_) return worker_.part(n, fine);
      const auto mine = team_.ranks_.part(team_.ranks_.rank(), n, grain);
      const auto of_it = worker_.part(mine.end - mine.first, fine);
      return {mine.first + of_it.first, mine.first + of_it.last};
    }
    [[nodiscard]] Workers::Range part(std::int64_t n, std::int64_t grain) const {
      return part(n, grain, grain);
    }

    // A barrier for all workers of the rank, and all ranks know all n items of which each made its part.
    template <class T>
    void gather(T* all, std::int64_t n, std::int64_t grain) const {
      talk([&](const Ranks& ranks) { ranks.gather_parts(all, n, grain); });
    }
    // The same for what others need of a part.
    void exchange(Halo* halo, double* values) const {
      talk([&](const Ranks& ranks) { halo->exchange(ranks, values); });
    }

   private:
    template <class Words>
    void talk(const Words& words) const {
      worker_.barrier();
      if (!over_ranks_) return;
      if (is_first() && !team_.failure_) {
        try {
          words(team_.ranks_);
        } catch (...) {
          team_.failure_ = std::current_exception();
        }
      }
      worker_.barrier();
    }
    RankTeam& team_;
    Workers::Member worker_;
    bool over_ranks_;
  };

  // Runs task(member) on the workers, or on the calling thread alone; ranks share the task, or each does all of it.
  template <class Task>
  void share(bool by_workers, bool over_ranks, const Task& task) {
    failure_ = nullptr;
    workers_.share(by_workers, [&](const Workers::Member& worker) {
      task(Member(*this, worker, over_ranks && !ranks_.alone()));
    });
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  Workers& workers_;
  Ranks ranks_;
  std::exception_ptr failure_;  // of the first worker, of the task at hand
};

}  // namespace hfrac
