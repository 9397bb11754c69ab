// SPDX-License-Identifier: BSD-3-Clause
// Ranks that are threads of one process, for tests: the transport of hfrac/exchange.h (in the library: core/ranks.hpp) without MPI, so that
// sanitizers see all of it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace rank_threads {

class Meeting {
 public:
  explicit Meeting(int32_t size) : size_(size), seats_(static_cast<std::size_t>(size)) {
    for (int32_t r = 0; r < size; ++r) seats_[static_cast<std::size_t>(r)] = {this, r, {}};
  }

  // The functions of a rank's table.
  template <class Message, class Table>
  void fill(Table& table, int32_t rank) {
    table.rank = rank;
    table.size = size_;
    table.user = &seats_[static_cast<std::size_t>(rank)];
    table.start = [](void* user, const Message* messages, int32_t count) -> int32_t {
      auto& seat = *static_cast<Seat*>(user);
      return seat.meeting->start(seat, messages, count);
    };
    table.finish = [](void* user) -> int32_t {
      auto& seat = *static_cast<Seat*>(user);
      return seat.meeting->finish(seat);
    };
    table.sum = [](void* user, int64_t* values, int32_t count) {
      return static_cast<Seat*>(user)->meeting->sum(values, count);
    };
    table.gather = [](void* user, void* all, const int64_t* begin) {
      auto& seat = *static_cast<Seat*>(user);
      return seat.meeting->gather(seat, all, begin);
    };
    table.fail = [](void* user) { return static_cast<Seat*>(user)->meeting->fail(); };
    table.fail_text = [](void* user, const char* text) {
      auto& seat = *static_cast<Seat*>(user);
      return seat.meeting->fail_text(seat, text);
    };
    table.failed = [](void* user, int32_t* by, char* text, int32_t size) {
      return static_cast<Seat*>(user)->meeting->failed(by, text, size);
    };
  }

  // Runs work(rank) on a thread for each rank.
  void run(const std::function<void(int32_t)>& work) {
    std::vector<std::thread> threads;
    for (int32_t r = 0; r < size_; ++r) threads.emplace_back([&work, r] { work(r); });
    for (auto& thread : threads) thread.join();
  }

 private:
  using Bytes = std::vector<unsigned char>;
  struct Expected {
    int32_t from;
    void* to;
    std::size_t bytes;
  };
  struct Seat {
    Meeting* meeting;
    int32_t rank;
    std::vector<Expected> expected;
  };

  template <class Message>
  int32_t start(Seat& seat, const Message* messages, int32_t count) {
    const std::scoped_lock lock(mutex_);
    for (int32_t k = 0; k < count; ++k) {
      const Message& m = messages[k];
      if (m.send_bytes > 0) {
        const auto* from = static_cast<const unsigned char*>(m.send);
        mail_[{seat.rank, m.rank}].emplace_back(from, from + m.send_bytes);
      }
      if (m.receive_bytes > 0)
        seat.expected.push_back({m.rank, m.receive, static_cast<std::size_t>(m.receive_bytes)});
    }
    changed_.notify_all();
    return failed_ ? 1 : 0;
  }

  int32_t finish(Seat& seat) {
    std::unique_lock lock(mutex_);
    for (const auto& [from, to, bytes] : seat.expected) {
      auto& box = mail_[{from, seat.rank}];
      wait(lock, [&] { return !box.empty(); });
      if (failed_) break;
      EXPECT_EQ(box.front().size(), bytes) << "from rank " << from << " to " << seat.rank;
      std::memcpy(to, box.front().data(), std::min(bytes, box.front().size()));
      box.pop_front();
    }
    seat.expected.clear();
    return failed_ ? 1 : 0;
  }

  // Until it is so or a rank has failed. Who waits for so long waits for one that makes other calls, or none: then all fail.
  template <class Condition>
  void wait(std::unique_lock<std::mutex>& lock, const Condition& condition) {
    constexpr std::chrono::seconds longest{60};
    if (changed_.wait_for(lock, longest, [&] { return failed_ || condition(); })) return;
    give_up("a rank has waited for the others for a minute");
  }

  void give_up(const char* why) {
    ADD_FAILURE() << why;
    failed_ = true;
    changed_.notify_all();
  }

  // Each brings something; the last to come opens the door for all, and `meet` says false to all once a rank has failed. All come for
  // the same, a sum of so many or an array of so many bytes.
  template <class Bring>
  bool meet(std::unique_lock<std::mutex>& lock, std::int64_t what, const Bring& bring) {
    if (failed_) return false;
    if (here_ == 0) what_ = what;
    if (what != what_) {
      give_up("ranks make different calls at once");
      return false;
    }
    bring();
    const auto round = round_;
    if (++here_ == size_) {
      here_ = 0;
      ++round_;
      changed_.notify_all();
    } else {
      wait(lock, [&] { return round_ != round; });
    }
    return round_ != round;
  }

  int32_t sum(int64_t* values, int32_t count) {
    const auto n = static_cast<std::size_t>(count);
    std::unique_lock lock(mutex_);
    const auto add = [&] {
      if (here_ == 0) total_.assign(n, 0);
      for (std::size_t k = 0; k < n; ++k)
        total_[k] = static_cast<int64_t>(static_cast<std::uint64_t>(total_[k]) +
                                         static_cast<std::uint64_t>(values[k]));
    };
    if (!meet(lock, count, add)) return 1;
    std::copy(total_.begin(), total_.end(), values);
    return meet(lock, count, [] {}) ? 0 : 1;
  }

  int32_t gather(const Seat& seat, void* all, const int64_t* begin) {
    const auto r = static_cast<std::size_t>(seat.rank);
    auto* to = static_cast<unsigned char*>(all);
    std::unique_lock lock(mutex_);
    const auto bring = [&] {
      if (here_ == 0) whole_.assign(static_cast<std::size_t>(begin[size_]), 0);
      std::copy(to + begin[r], to + begin[r + 1], whole_.begin() + begin[r]);
    };
    const std::int64_t gathered = -1 - begin[size_];  // no number of a sum's
    if (!meet(lock, gathered, bring)) return 1;
    std::copy(whole_.begin() + begin[0], whole_.end(), to + begin[0]);
    return meet(lock, gathered, [] {}) ? 0 : 1;
  }

  int32_t fail() {
    const std::scoped_lock lock(mutex_);
    failed_ = true;
    changed_.notify_all();
    return 0;
  }

  int32_t fail_text(const Seat& seat, const char* text) {
    const std::scoped_lock lock(mutex_);
    reasons_.emplace(seat.rank, text);
    return 0;
  }

  int32_t failed(int32_t* rank, char* text, int32_t size) {
    const std::scoped_lock lock(mutex_);
    if (reasons_.empty()) return 1;
    *rank = reasons_.begin()->first;
    std::snprintf(text, static_cast<std::size_t>(size), "%s", reasons_.begin()->second.c_str());
    return 0;
  }

  int32_t size_;
  std::vector<Seat> seats_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::pair<int32_t, int32_t>, std::deque<Bytes>> mail_;
  std::vector<int64_t> total_;
  Bytes whole_;
  int32_t here_ = 0;
  std::int64_t what_ = 0;
  std::uint64_t round_ = 0;
  bool failed_ = false;
  std::map<int32_t, std::string> reasons_;
};

}  // namespace rank_threads
