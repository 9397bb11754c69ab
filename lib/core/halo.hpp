// SPDX-License-Identifier: BSD-3-Clause
// Which rows of an array, shared out over ranks, a rank tells the others, since theirs depend on them: one message to each.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/ranks.hpp"

namespace hfrac {

class Halo {
 public:
  struct Row {
    std::int32_t rank, row;
    friend bool operator==(const Row& a, const Row& b) { return a.rank == b.rank && a.row == b.row; }
    friend bool operator<(const Row& a, const Row& b) {
      return a.rank != b.rank ? a.rank < b.rank : a.row < b.row;
    }
  };
  // Own rows that a rank wants, and rows that are wanted of a rank: in any order, also several times. What one sends the other receives.
  Halo(std::vector<Row> send, std::vector<Row> receive)
      : send_(std::move(send)), receive_(std::move(receive)) {
    for (auto* rows : {&send_, &receive_}) {
      std::sort(rows->begin(), rows->end());
      rows->erase(std::unique(rows->begin(), rows->end()), rows->end());
    }
    out_.resize(send_.size());
    in_.resize(receive_.size());
    for (std::size_t s = 0, r = 0; s < send_.size() || r < receive_.size();) {
      const auto rank = s == send_.size()      ? receive_[r].rank
                        : r == receive_.size() ? send_[s].rank
                                               : std::min(send_[s].rank, receive_[r].rank);
      const auto end_of = [rank](const std::vector<Row>& rows, std::size_t at) {
        while (at < rows.size() && rows[at].rank == rank) ++at;
        return at;
      };
      const auto bytes = [](std::size_t count) { return static_cast<std::int64_t>(count * sizeof(double)); };
      const std::size_t end_s = end_of(send_, s), end_r = end_of(receive_, r);
      messages_.push_back({rank, 0, bytes(end_s - s), bytes(end_r - r), out_.data() + s, in_.data() + r});
      s = end_s;
      r = end_r;
    }
  }
  Halo(Halo&&) = default;
  Halo& operator=(Halo&&) = default;
  Halo(const Halo&) = delete;  // messages point into its own lists
  Halo& operator=(const Halo&) = delete;
  ~Halo() = default;

  void exchange(const Ranks& ranks, double* values) {
    for (std::size_t k = 0; k < send_.size(); ++k) out_[k] = values[send_[k].row];
    ranks.start(messages_);
    ranks.finish();
    for (std::size_t k = 0; k < receive_.size(); ++k) values[receive_[k].row] = in_[k];
  }

 private:
  std::vector<Row> send_, receive_;
  std::vector<double> out_, in_;
  std::vector<Message> messages_;
};

}  // namespace hfrac
