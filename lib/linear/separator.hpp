// SPDX-License-Identifier: BSD-3-Clause
// The lightest set of nodes that touches every edge between two halves of a graph.
//
// Taking it away leaves nothing between the halves, so it is where nested dissection (dissection.hpp) cuts. Between two sides it
// is found exactly: it weighs as much as the largest flow from one side to the other through nodes that let their own weight
// pass (Koenig 1931; Ford and Fulkerson 1956), and consists of the nodes where that flow is stuck.
#pragma once

#include <cstdint>
#include <vector>

namespace hfrac {

struct Crossing {
  std::int32_t left, right;
};

// Nodes are numbered 0 to weights - 1 on either side; weights are positive. Marks those of the set.
void lightest_cover(const std::vector<std::int32_t>& left_weight,
                    const std::vector<std::int32_t>& right_weight, const std::vector<Crossing>& crossings,
                    std::vector<char>& left_in, std::vector<char>& right_in);

}  // namespace hfrac
