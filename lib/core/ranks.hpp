// SPDX-License-Identifier: BSD-3-Clause
// One model on several ranks: processes, or threads of one, that each hold all of it and share the work.
//
// The library knows no MPI. Whoever made the ranks gives a table of functions by which they talk (hfrac/exchange.h); alone, nothing is
// called. Floating-point numbers are never added by the table: sums go as the integers of ExactSum, so that they have the same bits
// on any number of ranks. What all ranks find alike, they find each for itself; what only one can run into (memory, the host's wish
// to stop) they are told of, so that none waits for one that has gone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace hfrac {

// As hfrac_message and hfrac_exchange (capi/include/hfrac/exchange.h). Each function returns 0; anything else ends what the ranks do
// together.
struct Message {
  std::int32_t rank = 0, pad = 0;
  std::int64_t send_bytes = 0, receive_bytes = 0;
  const void* send = nullptr;
  void* receive = nullptr;
};

struct OutsideSolver;  // linear/outside_matrix.hpp

struct Exchange {
  std::int32_t rank = 0, size = 1;
  void* user = nullptr;
  std::int32_t (*start)(void* user, const Message* messages, std::int32_t count) = nullptr;
  std::int32_t (*finish)(void* user) = nullptr;
  std::int32_t (*sum)(void* user, std::int64_t* values, std::int32_t count) = nullptr;
  std::int32_t (*gather)(void* user, void* all, const std::int64_t* begin) = nullptr;
  std::int32_t (*fail)(void* user) = nullptr;
  std::int32_t (*fail_text)(void* user, const char* text) = nullptr;  // may be missing, as the next
  std::int32_t (*failed)(void* user, std::int32_t* rank, char* text, std::int32_t size) = nullptr;
  const OutsideSolver* solver = nullptr;
};

class Ranks {
 public:
  Ranks() = default;
  explicit Ranks(const Exchange& exchange) : exchange_(exchange) {}

  [[nodiscard]] bool alone() const { return exchange_.size == 1; }
  [[nodiscard]] int rank() const { return exchange_.rank; }
  [[nodiscard]] int size() const { return exchange_.size; }
  // Of linear equations, by all ranks together; none: each has the library's own only.
  [[nodiscard]] const OutsideSolver* solver() const { return exchange_.solver; }

  // The part of n items, in multiples of `grain`, that belongs to a rank.
  struct Part {
    std::int64_t first, end;
  };
  [[nodiscard]] Part part(int rank, std::int64_t n, std::int64_t grain) const {
    const std::int64_t pieces = (n + grain - 1) / grain;
    const auto begin_of = [&](std::int64_t r) { return std::min(n, pieces * r / size() * grain); };
    return {begin_of(rank), begin_of(rank + 1)};
  }
  // Whose part item i is.
  [[nodiscard]] std::int32_t owner(std::int64_t i, std::int64_t n, std::int64_t grain) const {
    return static_cast<std::int32_t>(((i / grain + 1) * size() - 1) / ((n + grain - 1) / grain));
  }

  // All of these are called by all ranks, in the same order. Throw Error(exchange) where the others no longer answer.
  void sum(std::span<std::int64_t> values) const {
    if (!alone())
      check(exchange_.sum(exchange_.user, values.data(), static_cast<std::int32_t>(values.size())));
  }
  [[nodiscard]] bool any(bool here) const {
    std::int64_t count = here ? 1 : 0;
    sum({&count, 1});
    return count > 0;
  }
  // Of an array that all have, rank r knows what lies from begin[r] to begin[r + 1]: then all know all of it.
  template <class T>
  void gather(T* all, std::vector<std::int64_t> begin) const {
    if (alone()) return;
    for (auto& place : begin) place *= static_cast<std::int64_t>(sizeof(T));
    check(exchange_.gather(exchange_.user, all, begin.data()));
  }
  // The same where one knows all n of it.
  template <class T>
  void tell(int from, T* all, std::int64_t n) const {
    if (alone()) return;
    std::vector<std::int64_t> begin(static_cast<std::size_t>(size()) + 1, n);
    std::fill_n(begin.begin(), from + 1, 0);
    gather(all, std::move(begin));
  }
  // The same where each made its part of n items.
  template <class T>
  void gather_parts(T* all, std::int64_t n, std::int64_t grain) const {
    if (alone()) return;
    std::vector<std::int64_t> begin;
    begin.reserve(static_cast<std::size_t>(size()) + 1);
    for (int r = 0; r < size(); ++r) begin.push_back(part(r, n, grain).first);
    begin.push_back(n);
    gather(all, std::move(begin));
  }
  // What each rank has of a list, in order of ranks.
  template <class T>
  [[nodiscard]] std::vector<T> gather(const std::vector<T>& mine) const {
    if (alone()) return mine;
    std::vector<std::int64_t> begin(static_cast<std::size_t>(size()) + 1, 0);
    const auto here = static_cast<std::size_t>(rank());
    std::vector<std::int64_t> count(static_cast<std::size_t>(size()), 0);
    count[here] = static_cast<std::int64_t>(mine.size());
    sum(count);
    for (std::size_t r = 0; r < count.size(); ++r) begin[r + 1] = begin[r] + count[r];
    std::vector<T> all(static_cast<std::size_t>(begin.back()));
    if (all.empty()) return all;
    std::copy(mine.begin(), mine.end(), all.begin() + static_cast<std::ptrdiff_t>(begin[here]));
    gather(all.data(), begin);
    return all;
  }

  // One message to each of some ranks and one from each; their memory stays as it is until finish().
  void start(std::span<const Message> messages) const {
    check(exchange_.start(exchange_.user, messages.data(), static_cast<std::int32_t>(messages.size())));
  }
  void finish() const { check(exchange_.finish(exchange_.user)); }

  // This rank cannot go on, for the reason given: the others' calls fail from now on, and so do its own.
  void fail(const char* reason) const noexcept {
    if (alone()) return;
    if (exchange_.fail_text != nullptr) exchange_.fail_text(exchange_.user, reason);
    exchange_.fail(exchange_.user);
  }

 private:
  void check(std::int32_t status) const {
    if (status == 0) return;
    std::int32_t failed = 0;
    char reason[512] = "";
    const bool told = exchange_.failed != nullptr &&
                      exchange_.failed(exchange_.user, &failed, reason, sizeof reason) == 0 &&
                      failed != rank();
    throw Error(ErrorKind::exchange,
                (told ? "rank " + std::to_string(failed) + " has failed: " + reason
                      : std::string("another rank has failed or is no longer there.")) +
                    " Destroy the simulation on all ranks and go on from the last state that was saved.");
  }
  Exchange exchange_;
};

}  // namespace hfrac
