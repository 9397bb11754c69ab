// SPDX-License-Identifier: BSD-3-Clause
// Worker threads of one simulation.
//
// A time step is a handful of short passes over arrays, so threads that sleep between passes would spend the step
// waking up. Here a whole batch of cycles runs inside one parallel region, and the workers meet at a barrier that
// spins for a moment before it sleeps; where there are more workers than cores, it gives the core away at once.
// Which worker does which part is fixed by index ranges, and no worker adds into what another one adds into, so
// results do not depend on how many there are.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace hfrac {

class Workers {
 public:
  explicit Workers(int count);
  ~Workers();
  // Threads do not come along into a forked child: there, several workers can neither run nor be waited for. run() says
  // so, and this leaves what belongs to the parent's threads as it is.
  struct Release {
    void operator()(Workers* workers) const;
  };
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  [[nodiscard]] int count() const { return count_; }

  // Runs task(worker) once on every worker, the calling thread being worker 0; returns when all are done.
  // The task must not throw. Throws Error(argument) in a forked child.
  void run(const std::function<void(int)>& task);

  // Inside a task: waits until all workers have come here.
  void barrier();

  // Inside a task: waits until `done`, which another worker raises and notifies of, is at least that.
  void wait_for(const std::atomic<std::int32_t>& done, std::int32_t at_least) const;

  // The part [first, last) of n items, in multiples of `grain`, that belongs to a worker.
  struct Range {
    std::int64_t first;
    std::int64_t last;
  };
  [[nodiscard]] Range part(int worker, std::int64_t n, std::int64_t grain) const {
    return part_of(worker, count_, n, grain);
  }

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
      run([&](int worker) { task(Member{*this, worker, count_}); });
    else
      task(Member{*this, 0, 1});
  }

 private:
  static Range part_of(int worker, int workers, std::int64_t n, std::int64_t grain);
  void loop(int worker);
  void end_threads();

  [[nodiscard]] bool forked() const;
  template <class Number>
  void wait_while(const std::atomic<Number>& number, Number old) const;

  int count_;
  bool crowded_;          // more workers than cores
  std::int64_t process_;  // that made the threads
  std::vector<std::thread> threads_;
  const std::function<void(int)>* task_ = nullptr;  // none: the end
  std::atomic<std::uint32_t> tasks_{0};             // given so far
  std::atomic<int> running_{0};
  std::atomic<int> arrived_{0};
  std::atomic<std::uint32_t> phase_{0};
};

}  // namespace hfrac
