// SPDX-License-Identifier: BSD-3-Clause
#include "core/workers.hpp"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <system_error>

#include "core/error.hpp"

namespace hfrac {
namespace {

constexpr std::uint32_t most_workers = 1024;  // more than run.workers may be
// Waiting, in nanoseconds. A worker that is about to come is spun for; beyond that one may have lost its core, and whoever
// waits sleeps, so that the core goes to whom is waited for.
constexpr std::int64_t patience = 50'000;
// The watch: the share of a window's time spent waiting that makes the team smaller; windows; the pause after which a larger team is
// tried, doubled by each try that fails, and what ends the doubling.
constexpr double too_late = 0.3;
constexpr std::int64_t window = 3'000'000, longest_wait = 1'500'000, shortest_pause = 20'000'000,
                       longest_pause = 2'000'000'000, proven = 200'000'000;

std::int64_t nanoseconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(time).count();
}

// Every signal blocked on this thread until the end of the scope: threads begun in it inherit that.
class NoSignals {
 public:
  NoSignals() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~NoSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  NoSignals(const NoSignals&) = delete;
  NoSignals& operator=(const NoSignals&) = delete;

 private:
  sigset_t before_;
};

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
    : count_(std::max(1, count)),
      cores_(usable_cores()),
      active_(count_),
      process_(::getpid()),
      pause_(shortest_pause) {
  try {
    const NoSignals here;
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
  give(count_);
  for (auto& thread : threads_) thread.join();
}

// The next task, to workers 0 to active - 1.
void Workers::give(int active) {
  const std::uint32_t given = tasks_.load(std::memory_order_relaxed) / most_workers;
  tasks_.store((given + 1) * most_workers + static_cast<std::uint32_t>(active), std::memory_order_release);
  tasks_.notify_all();
}

// Whether a number is no longer `old` before patience ends. With more workers at work than cores nobody spins: it would keep the core
// from whom it waits for.
template <class Number>
bool Workers::spin_while(const std::atomic<Number>& number, Number old, int at_work) const {
  constexpr int spins = 64;  // between looks at the clock
  const auto came = [&] { return number.load(std::memory_order_acquire) != old; };
  if (came()) return true;
  const auto begin = Clock::now();
  while (at_work <= cores_ && nanoseconds(Clock::now() - begin) < patience) {
    for (int k = 0; k < spins; ++k) {
      if (came()) return true;
#if defined(__x86_64__)
      __builtin_ia32_pause();
#endif
    }
  }
  return came();
}

// Waits until a number is no longer `old`; returns for how long beyond patience [ns].
template <class Number>
std::int64_t Workers::wait_while(const std::atomic<Number>& number, Number old, int at_work) const {
  if (number.load(std::memory_order_acquire) != old) return 0;
  const auto begin = Clock::now();
  if (spin_while(number, old, at_work)) return 0;
  while (number.load(std::memory_order_acquire) == old) number.wait(old, std::memory_order_acquire);
  return std::max<std::int64_t>(0, nanoseconds(Clock::now() - begin) - patience);
}

template <class Number>
void Workers::wait_and_count(const std::atomic<Number>& number, Number old) const {
  const std::int64_t late = wait_while(number, old, active_);
  if (late > 0) late_.fetch_add(late, std::memory_order_relaxed);
}

bool Workers::forked() const {
  return count_ > 1 && process_ != ::getpid();
}

void Workers::Release::operator()(Workers* workers) const {
  if (!workers->forked()) delete workers;
}

void Workers::run(const std::function<void(int)>& task, bool even) {
  if (forked()) {
    throw Error(ErrorKind::argument,
                "this simulation's workers stayed behind in the process that was forked; build it in the "
                "child, or set "
                "run.workers = 1.");
  }
  const auto begin = count_ > 1 ? Clock::now() : Clock::time_point{};
  if (active_ < count_ && nanoseconds(begin - shrunk_) >= pause_) {
    active_ = std::min(count_, 2 * active_);
    shrunk_ = begin;
    begin_window();
  }
  cut_short_ = false;
  if (active_ > 1) {
    running_.store(active_ - 1, std::memory_order_relaxed);
    task_ = &task;
    give(active_);
  }
  task(0);
  if (active_ == 1) return;
  for (int left = running_.load(std::memory_order_acquire); left != 0;
       left = running_.load(std::memory_order_acquire)) {
    wait_and_count(running_, left);
  }
  watch(begin, even);
}

void Workers::begin_window() {
  busy_ = 0;
  late_.store(0, std::memory_order_relaxed);
}

// After a task: how much of the window the team stood waiting. All but one wait for one, so that is the unit.
void Workers::watch(Clock::time_point begin, bool even) {
  if (!even) {
    begin_window();
    return;
  }
  const auto now = Clock::now();
  busy_ += nanoseconds(now - begin);
  if (busy_ < window) return;
  const auto stood = static_cast<double>(late_.load(std::memory_order_relaxed)) / (active_ - 1);
  if (stood > too_late * static_cast<double>(busy_)) {
    active_ = active_ > cores_ ? cores_ : active_ / 2;
    pause_ = good_ < proven ? std::min(2 * pause_, longest_pause) : shortest_pause;
    good_ = 0;
    shrunk_ = now;
  } else {
    good_ += busy_;
  }
  begin_window();
}

void Workers::loop(int worker) {
  int at_work = count_;  // in the last task; active_ is the calling thread's between tasks
  for (std::uint32_t seen = 0;;) {
    wait_while(tasks_, seen, at_work);
    seen = tasks_.load(std::memory_order_acquire);
    at_work = static_cast<int>(seen % most_workers);
    if (worker >= at_work) continue;  // not of this one
    if (task_ == nullptr) return;
    (*task_)(worker);
    running_.fetch_sub(1, std::memory_order_release);
    running_.notify_one();
  }
}

void Workers::barrier() {
  if (active_ == 1) return;
  const std::uint32_t phase = phase_.load(std::memory_order_acquire);
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == active_) {
    arrived_.store(0, std::memory_order_relaxed);
    cut_short_ = late_.load(std::memory_order_relaxed) > (active_ - 1) * longest_wait;
    phase_.store(phase + 1, std::memory_order_release);
    phase_.notify_all();
  } else {
    wait_and_count(phase_, phase);
  }
}

bool Workers::comes_soon(const std::atomic<std::int32_t>& done, std::int32_t at_least) const {
  for (std::int32_t now = done.load(std::memory_order_acquire); now < at_least;
       now = done.load(std::memory_order_acquire)) {
    if (!spin_while(done, now, active_)) return false;
  }
  return true;
}

void Workers::wait_for(const std::atomic<std::int32_t>& done, std::int32_t at_least) const {
  for (std::int32_t now = done.load(std::memory_order_acquire); now < at_least;
       now = done.load(std::memory_order_acquire)) {
    wait_and_count(done, now);
  }
}

void Workers::Pass::refill(const Workers& team, std::int64_t n) {
  active_ = team.active();
  for (int worker = 0; worker < active_; ++worker) {
    const Range part = team.part(worker, n, 1);
    next_[static_cast<std::size_t>(worker)].at.store(part.first, std::memory_order_relaxed);
    next_[static_cast<std::size_t>(worker)].last = part.last;
  }
}

Workers::Range Workers::part_of(int worker, int workers, std::int64_t n, std::int64_t grain) {
  const std::int64_t blocks = (n + grain - 1) / grain;
  const std::int64_t first = blocks * worker / workers;
  const std::int64_t last = blocks * (worker + 1) / workers;
  return {std::min(n, first * grain), std::min(n, last * grain)};
}

}  // namespace hfrac
