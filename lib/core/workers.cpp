// SPDX-License-Identifier: BSD-3-Clause
#include "core/workers.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <system_error>

#include "core/error.hpp"

namespace hfrac {
namespace {

constexpr int most_spins = 4000, most_yields = 20;

// Cores this process may use, which can be fewer than the machine has (taskset, a scheduler's cpuset).
int usable_cores() {
#if defined(__linux__)
  cpu_set_t set;
  if (::sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
#endif
  return static_cast<int>(std::thread::hardware_concurrency());
}

}  // namespace

Workers::Workers(int count)
    : count_(std::max(1, count)), crowded_(count_ > usable_cores()), process_(::getpid()) {
  try {
    threads_.reserve(static_cast<std::size_t>(count_ - 1));
    for (int worker = 1; worker < count_; ++worker) threads_.emplace_back([this, worker] { loop(worker); });
  } catch (const std::system_error&) {  // the system gives no more threads
    const std::size_t started = threads_.size() + 1;
    end_threads();
    throw Error(ErrorKind::memory, "only " + std::to_string(started) + " of " + std::to_string(count_) +
                                       " workers could be started; lower run.workers.");
  } catch (...) {
    end_threads();
    throw;
  }
}

Workers::~Workers() {
  end_threads();
}

void Workers::end_threads() {
  task_ = nullptr;
  tasks_.fetch_add(1, std::memory_order_release);
  tasks_.notify_all();
  for (auto& thread : threads_) thread.join();
}

// Waits until a number is no longer `old`. With a core for every worker what is waited for comes soon, and a few thousand
// spins (tens to hundreds of microseconds) are all it takes. With fewer, spinning keeps it from coming: the core goes to
// the next worker at once. Whoever waits longer sleeps, so that on a busy machine the core goes to whom is waited for.
template <class Number>
void Workers::wait_while(const std::atomic<Number>& number, Number old) const {
  for (int spins = crowded_ ? 0 : most_spins; spins > 0; --spins) {
    if (number.load(std::memory_order_acquire) != old) return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  for (int yields = 0; yields < most_yields; ++yields) {
    if (number.load(std::memory_order_acquire) != old) return;
    std::this_thread::yield();
  }
  while (number.load(std::memory_order_acquire) == old) number.wait(old, std::memory_order_acquire);
}

bool Workers::forked() const {
  return count_ > 1 && process_ != ::getpid();
}

void Workers::Release::operator()(Workers* workers) const {
  if (!workers->forked()) delete workers;
}

void Workers::run(const std::function<void(int)>& task) {
  if (count_ == 1) {
    task(0);
    return;
  }
  if (forked()) {
    throw Error(ErrorKind::argument,
                "this simulation's workers stayed behind in the process that was forked; build it in the "
                "child, or set "
                "run.workers = 1.");
  }
  running_.store(count_ - 1, std::memory_order_relaxed);
  task_ = &task;
  tasks_.fetch_add(1, std::memory_order_release);
  tasks_.notify_all();
  task(0);
  for (int left = running_.load(std::memory_order_acquire); left != 0;
       left = running_.load(std::memory_order_acquire)) {
    wait_while(running_, left);
  }
}

void Workers::loop(int worker) {
  for (std::uint32_t seen = 0;; ++seen) {
    wait_while(tasks_, seen);
    if (task_ == nullptr) return;
    (*task_)(worker);
    running_.fetch_sub(1, std::memory_order_release);
    running_.notify_one();
  }
}

void Workers::barrier() {
  if (count_ == 1) return;
  const std::uint32_t phase = phase_.load(std::memory_order_acquire);
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == count_) {
    arrived_.store(0, std::memory_order_relaxed);
    phase_.store(phase + 1, std::memory_order_release);
    phase_.notify_all();
  } else {
    wait_while(phase_, phase);
  }
}

void Workers::wait_for(const std::atomic<std::int32_t>& done, std::int32_t at_least) const {
  for (std::int32_t now = done.load(std::memory_order_acquire); now < at_least;
       now = done.load(std::memory_order_acquire)) {
    wait_while(done, now);
  }
}

Workers::Range Workers::part_of(int worker, int workers, std::int64_t n, std::int64_t grain) {
  const std::int64_t blocks = (n + grain - 1) / grain;
  const std::int64_t first = blocks * worker / workers;
  const std::int64_t last = blocks * (worker + 1) / workers;
  return {std::min(n, first * grain), std::min(n, last * grain)};
}

}  // namespace hfrac
