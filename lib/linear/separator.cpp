// SPDX-License-Identifier: BSD-3-Clause
#include "linear/separator.hpp"

#include <algorithm>

namespace hfrac {
namespace {

std::size_t at(std::int32_t k) {
  return static_cast<std::size_t>(k);
}

// Flow from left to right nodes along crossings, which have no limit of their own.
struct Flow {
  const std::vector<Crossing>& crossings;
  std::vector<std::int32_t> left_free, right_free;  // what nodes still let pass
  std::vector<std::int32_t> left_start, left_edge, right_start, right_edge, through;
  std::vector<char> left_seen, right_seen;

  Flow(const std::vector<std::int32_t>& left, const std::vector<std::int32_t>& right,
       const std::vector<Crossing>& all)
      : crossings(all),
        left_free(left),
        right_free(right),
        left_start(left.size() + 1, 0),
        left_edge(all.size()),
        right_start(right.size() + 1, 0),
        right_edge(all.size()),
        through(all.size(), 0),
        left_seen(left.size(), 0),
        right_seen(right.size(), 0) {
    for (const auto& c : all) {
      ++left_start[at(c.left) + 1];
      ++right_start[at(c.right) + 1];
    }
    for (std::size_t k = 0; k < left.size(); ++k) left_start[k + 1] += left_start[k];
    for (std::size_t k = 0; k < right.size(); ++k) right_start[k + 1] += right_start[k];
    auto left_cursor = left_start, right_cursor = right_start;
    for (std::size_t e = 0; e < all.size(); ++e) {
      left_edge[at(left_cursor[at(all[e].left)]++)] = static_cast<std::int32_t>(e);
      right_edge[at(right_cursor[at(all[e].right)]++)] = static_cast<std::int32_t>(e);
    }
  }

  // Sends up to `most` on from a left node; returns how much found a way.
  std::int32_t send(std::int32_t node, std::int32_t most) {
    left_seen[at(node)] = 1;
    for (auto k = left_start[at(node)]; k < left_start[at(node) + 1]; ++k) {
      const auto e = left_edge[at(k)];
      const auto far = crossings[at(e)].right;
      if (right_seen[at(far)] != 0) continue;
      right_seen[at(far)] = 1;
      std::int32_t sent = std::min(most, right_free[at(far)]);
      if (sent > 0) {
        right_free[at(far)] -= sent;
        through[at(e)] += sent;
        return sent;
      }
      // Full: make room by sending on elsewhere what comes to it from another left node.
      for (auto q = right_start[at(far)]; q < right_start[at(far) + 1]; ++q) {
        const auto back = right_edge[at(q)];
        const auto other = crossings[at(back)].left;
        if (through[at(back)] == 0 || left_seen[at(other)] != 0) continue;
        sent = send(other, std::min(most, through[at(back)]));
        if (sent == 0) continue;
        through[at(back)] -= sent;
        through[at(e)] += sent;
        return sent;
      }
    }
    return 0;
  }

  void forget_seen() {
    std::fill(left_seen.begin(), left_seen.end(), 0);
    std::fill(right_seen.begin(), right_seen.end(), 0);
  }
};

}  // namespace

void lightest_cover(const std::vector<std::int32_t>& left_weight,
                    const std::vector<std::int32_t>& right_weight, const std::vector<Crossing>& crossings,
                    std::vector<char>& left_in, std::vector<char>& right_in) {
  Flow flow(left_weight, right_weight, crossings);
  // In turns: one look at every node, and what was seen in vain is not looked at again in the same turn.
  for (bool more = true; more;) {
    more = false;
    flow.forget_seen();
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(left_weight.size()); ++k) {
      if (flow.left_free[at(k)] == 0 || flow.left_seen[at(k)] != 0) continue;
      const auto sent = flow.send(k, flow.left_free[at(k)]);
      flow.left_free[at(k)] -= sent;
      more = more || sent > 0;
    }
  }
  // The last turn saw all that can still be reached: left nodes not among it and right nodes among it are where flow is stuck.
  left_in.assign(left_weight.size(), 0);
  right_in.assign(right_weight.size(), 0);
  for (std::size_t k = 0; k < left_in.size(); ++k) left_in[k] = flow.left_seen[k] != 0 ? 0 : 1;
  for (std::size_t k = 0; k < right_in.size(); ++k) right_in[k] = flow.right_seen[k];
}

}  // namespace hfrac
