// SPDX-License-Identifier: BSD-3-Clause
#include "run/threads.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace hfrac::run {
namespace {

/** Threads that end before it does, and see no signal: a host's handlers run on the host's own threads. */
class Helpers {
 public:
  template <class Work>
  Helpers(size_t count, const Work& work) {
    sigset_t all, before;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);
    try {
      threads_.reserve(count);
      for (size_t k = 1; k <= count; ++k) threads_.emplace_back(work, k);
    } catch (const std::system_error&) {  // as many as the system allows
    } catch (const std::bad_alloc&) {
    }
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;
  ~Helpers() {
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  std::vector<std::thread> threads_;
};

}  // namespace

void share_out(int workers, size_t count, const std::function<void(size_t worker, size_t item)>& task) {
  std::atomic<size_t> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const auto work = [&](size_t worker) {
    try {
      for (size_t item = next++; item < count; item = next++) task(worker, item);
    } catch (...) {
      next = count;  // the others end as well
      const std::scoped_lock lock(failing);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    const size_t most = std::min(static_cast<size_t>(std::max(workers, 1)), count);
    const Helpers helpers(most > 1 ? most - 1 : 0, work);
    work(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace hfrac::run
