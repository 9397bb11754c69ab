// SPDX-License-Identifier: BSD-3-Clause
// Worker threads of one simulation.
//
// A time step is a handful of short passes over arrays, so threads that sleep between passes would spend the step
// waking up. Here a whole batch of cycles runs inside one parallel region, and the workers meet at a barrier that
// spins for a moment before it sleeps. No worker adds into what another one adds into, and sums have a fixed order, so
// results do not depend on how many there are, nor on who does what.
//
// Beside other programs a worker may lose its core for some milliseconds while the others wait for it. So the team
// watches how much of its time it waits like that: where it is much, the next regions run on half as many workers
// (the rest sleep), in the end on the calling thread alone; after a pause it tries the larger team again. A try that
// fails doubles the pause. What this costs beside busy programs is a few milliseconds a second.
//
// Worker threads block every signal a thread can block: a host's handlers run on the host's own threads.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace hfrac {

class Workers {
 public:
  explicit Workers(int count);  // 1 to 1023
  ~Workers();
  // Threads do not come along into a forked child: there, several workers can neither run nor be waited for. run() says
  // so, and this leaves what belongs to the parent's threads as it is.
  struct Release {
    void operator()(Workers* workers) const;
  };
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] bool forked() const;  // in a child, where there are none of several
  // Of them, how many do the task at hand, or the next one. Changes between tasks only.
  [[nodiscard]] int active() const { return active_; }

  // Runs task(worker) once on every active worker, the calling thread being worker 0; returns when all are done.
  // The task must not throw. Throws Error(argument) in a forked child. `even`: workers have about equal work between
  // barriers, so that long waits mean a lost core; else the watch looks away.
  void run(const std::function<void(int)>& task, bool even = true);
  // Inside a task, behind a barrier, and the same for all workers: the team has waited so long for one of them that it
  // had better end this task and do what is left in a new one, with fewer.
  [[nodiscard]] bool cut_short() const { return cut_short_; }

  // Inside a task: waits until all active workers have come here.
  void barrier();

  // Inside a task: whether `done` is at least that, or is so before whoever works on it can be thought to have lost its core.
  [[nodiscard]] bool comes_soon(const std::atomic<std::int32_t>& done, std::int32_t at_least) const;
  // Inside a task: waits until `done`, which another worker raises and notifies of, is at least that.
  void wait_for(const std::atomic<std::int32_t>& done, std::int32_t at_least) const;

  // The part [first, last) of n items, in multiples of `grain`, that belongs to a worker.
  struct Range {
    std::int64_t first;
    std::int64_t last;
  };
  [[nodiscard]] Range part(int worker, std::int64_t n, std::int64_t grain) const {
    return part_of(worker, active_, n, grain);
  }

  // Inside a task: the n items of one pass, first come first served. A worker takes what is its part above, whose data its
  // cache may hold, and then what others have left of theirs, so that one who lost its core holds up one item, not its part.
  class Pass {
   public:
    explicit Pass(int most_workers) : next_(static_cast<std::size_t>(most_workers)) {}
    // Between two barriers in which nobody takes: all n items are there again.
    void refill(const Workers& team, std::int64_t n);
    template <class Item>
    void take(int worker, const Item& item) {
      for (int k = 0; k < active_; ++k) {
        Cursor& cursor = next_[static_cast<std::size_t>((worker + k) % active_)];
        for (auto at = cursor.at.fetch_add(1, std::memory_order_relaxed); at < cursor.last;
             at = cursor.at.fetch_add(1, std::memory_order_relaxed))
          item(at);
      }
    }

   private:
    struct alignas(64) Cursor {
      std::atomic<std::int64_t> at{0};
      std::int64_t last = 0;
    };
    std::vector<Cursor> next_;
    int active_ = 1;
  };

  // One of those who do a task together.
  struct Member {
    Workers& team;
    int number, count;
    [[nodiscard]] Range part(std::int64_t n, std::int64_t grain) const {
      return part_of(number, count, n, grain);
    }
    void barrier() const {
      if (count > 1) team.barrier();
    }
  };
  // Runs task(member) on every worker, or, if it is not worth that, once on the calling thread.
  template <class Task>
  void share(bool worth_it, const Task& task) {
    if (worth_it)
      run([&](int worker) { task(Member{*this, worker, active_}); });
    else
      task(Member{*this, 0, 1});
  }

 private:
  using Clock = std::chrono::steady_clock;
  static Range part_of(int worker, int workers, std::int64_t n, std::int64_t grain);
  void loop(int worker);
  void end_threads();

  template <class Number>
  bool spin_while(const std::atomic<Number>& number, Number old, int at_work) const;
  template <class Number>
  std::int64_t wait_while(const std::atomic<Number>& number, Number old, int at_work) const;
  template <class Number>
  void wait_and_count(const std::atomic<Number>& number, Number old) const;
  void give(int active);
  void begin_window();
  void watch(Clock::time_point begin, bool even);

  int count_, cores_;
  int active_;            // 1 to count_, of the task at hand
  std::int64_t process_;  // that made the threads
  std::vector<std::thread> threads_;
  const std::function<void(int)>* task_ = nullptr;  // none: the end
  // Tasks given so far times most_workers, plus how many do the last one: who does not take part reads one number only.
  std::atomic<std::uint32_t> tasks_{0};
  // The watch over the time that the team waits for one that lost its core; of the calling thread but for the first two.
  mutable std::atomic<std::int64_t> late_{
      0};  // ns that workers waited beyond patience, since the window began
  bool cut_short_ = false;
  std::int64_t busy_ = 0;     // ns of tasks in the window
  std::int64_t good_ = 0;     // ns of tasks without a reason to shrink
  std::int64_t pause_;        // ns until a larger team is tried
  Clock::time_point shrunk_;  // when the team became smaller
  std::atomic<int> running_{0};
  std::atomic<int> arrived_{0};
  std::atomic<std::uint32_t> phase_{0};
};

// Calls task(first, last) for parts of n items, in multiples of `grain`, each item once: on every worker, if there are any and it is
// worth that, else once on the calling thread.
template <class Task>
void share_items(Workers* workers, std::int64_t n, const Task& task, std::int64_t worth_sharing = 8192,
                 std::int64_t grain = 1024) {
  if (workers == nullptr || workers->count() == 1 || n < worth_sharing || workers->forked())
    return task(std::int64_t{0}, n);
  workers->share(true, [&](const Workers::Member& member) {
    const auto mine = member.part(n, grain);
    if (mine.first < mine.last) task(mine.first, mine.last);
  });
}

}  // namespace hfrac
