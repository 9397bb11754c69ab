// SPDX-License-Identifier: BSD-3-Clause
// A sparse L U factor of a matrix with symmetric pattern, by dense fronts (Duff and Reid 1983).
//
// Each part of a nested dissection becomes a front: a dense matrix of its own unknowns (pivots) and of those later ones that
// they or its children touch (boundary). A front is the sum of its entries of the matrix and of what its children left over;
// its pivots are eliminated and the rest is handed to its parent. Nearly all work is in products of dense blocks, which is why
// this is several times faster than a factor by scattered columns. Rows are exchanged within a front's pivots only, so what
// is stored follows from the pattern alone and is found once.
//
// Unknowns come in nodes (a disc has three, a domain one). Entries of the matrix are given as a list whose places stay the
// same from factor to factor; entries for the same place add up.
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"
#include "equilibrium/dissection.hpp"

namespace hfrac {

struct MatrixPlace {
  std::int32_t row, column;
};

class Multifrontal {
 public:
  // node_start[k]: first unknown of node k; graph: nodes that share an entry.
  void analyse(const std::vector<std::int32_t>& node_start, const std::vector<Vec2>& position,
               const Adjacency& graph, const std::vector<char>& late, const std::vector<MatrixPlace>& places);
  void factorise(const std::vector<double>& values);
  // Overwrites x, the right side, with the solution.
  void solve(double* x);

  [[nodiscard]] bool analysed() const { return !fronts_.empty(); }
  [[nodiscard]] std::int64_t entries() const {
    return static_cast<std::int64_t>(columns_.size() + rows_.size());
  }
  [[nodiscard]] double operations() const { return operations_; }

 private:
  struct Front {
    std::int32_t pivots = 0, size = 0;  // unknowns of its own, and with its boundary
    std::int32_t parent = -1, children = 0;
    std::int64_t unknowns = 0;  // where in unknowns_: size of them, pivots first
    std::int64_t columns = 0, rows = 0, swaps = 0, into_parent = 0;
    std::int64_t first_entry = 0, last_entry = 0;
  };
  std::vector<Front> fronts_;
  std::vector<std::int32_t> unknowns_;     // of the fronts
  std::vector<std::int32_t> into_parent_;  // place of each boundary unknown in the parent's front
  std::vector<std::int32_t> entry_, entry_row_,
      entry_column_;  // entries by front: number, place in the front
  std::vector<std::int32_t> swaps_;
  Array<double> columns_, rows_;                    // the factor
  Array<double> front_, stack_, pivot_, boundary_;  // work space
  double operations_ = 0.0;
};

}  // namespace hfrac
