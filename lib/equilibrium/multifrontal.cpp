// SPDX-License-Identifier: BSD-3-Clause
#include "equilibrium/multifrontal.hpp"

#include <algorithm>
#include <cstring>

#include "equilibrium/dense_kernels.hpp"

namespace hfrac {

void Multifrontal::analyse(const std::vector<std::int32_t>& node_start, const std::vector<Vec2>& position,
                           const Adjacency& graph, const std::vector<char>& late,
                           const std::vector<MatrixPlace>& places) {
  const Dissection cuts = dissect(position, graph, late);
  const auto nodes = position.size(), parts = cuts.parts.size();
  std::vector<std::int32_t> turn(nodes), part_of(nodes);
  for (std::size_t k = 0; k < nodes; ++k)
    turn[static_cast<std::size_t>(cuts.order[k])] = static_cast<std::int32_t>(k);
  for (std::size_t f = 0; f < parts; ++f) {
    for (auto k = cuts.parts[f].first; k < cuts.parts[f].last; ++k)
      part_of[static_cast<std::size_t>(cuts.order[static_cast<std::size_t>(k)])] =
          static_cast<std::int32_t>(f);
  }
  // Boundary of every part, as nodes in order of elimination: later neighbours of its own, and its children's boundaries.
  std::vector<std::vector<std::int32_t>> boundary(parts);
  const auto earlier = [&](std::int32_t a, std::int32_t b) {
    return turn[static_cast<std::size_t>(a)] < turn[static_cast<std::size_t>(b)];
  };
  for (std::size_t f = 0; f < parts; ++f) {
    auto& list = boundary[f];
    const auto& part = cuts.parts[f];
    for (auto k = part.first; k < part.last; ++k) {
      const auto node = static_cast<std::size_t>(cuts.order[static_cast<std::size_t>(k)]);
      for (auto q = graph.start[node]; q < graph.start[node + 1]; ++q) {
        const auto other = graph.neighbour[static_cast<std::size_t>(q)];
        if (turn[static_cast<std::size_t>(other)] >= part.last) list.push_back(other);
      }
    }
    std::sort(list.begin(), list.end(), earlier);
    list.erase(std::unique(list.begin(), list.end()), list.end());
    if (part.parent < 0) continue;
    auto& above = boundary[static_cast<std::size_t>(part.parent)];
    const auto& parent = cuts.parts[static_cast<std::size_t>(part.parent)];
    for (const auto node : list) {
      if (turn[static_cast<std::size_t>(node)] >= parent.last) above.push_back(node);
    }
  }

  fronts_.assign(parts, {});
  unknowns_.clear();
  into_parent_.clear();
  std::vector<std::int32_t> local(static_cast<std::size_t>(node_start.back()), -1);
  std::int64_t columns = 0, rows = 0, swaps = 0, largest = 0, stacked = 0, most_stacked = 0;
  operations_ = 0.0;
  const auto add_node = [&](std::int32_t node) {
    for (auto u = node_start[static_cast<std::size_t>(node)];
         u < node_start[static_cast<std::size_t>(node) + 1]; ++u)
      unknowns_.push_back(u);
  };
  for (std::size_t f = 0; f < parts; ++f) {
    Front& front = fronts_[f];
    front.unknowns = static_cast<std::int64_t>(unknowns_.size());
    for (auto k = cuts.parts[f].first; k < cuts.parts[f].last; ++k)
      add_node(cuts.order[static_cast<std::size_t>(k)]);
    front.pivots = static_cast<std::int32_t>(static_cast<std::int64_t>(unknowns_.size()) - front.unknowns);
    for (const auto node : boundary[f]) add_node(node);
    front.size = static_cast<std::int32_t>(static_cast<std::int64_t>(unknowns_.size()) - front.unknowns);
    front.parent = cuts.parts[f].parent;
    front.columns = columns;
    front.rows = rows;
    front.swaps = swaps;
    const std::int64_t m = front.size, p = front.pivots, b = m - p;
    columns += m * p;
    rows += p * b;
    swaps += p;
    largest = std::max(largest, m);
    for (std::int64_t k = 0; k < p; ++k) operations_ += 2.0 * static_cast<double>((m - k) * (m - k));
  }
  for (auto& front : fronts_) {
    if (front.parent >= 0) ++fronts_[static_cast<std::size_t>(front.parent)].children;
  }
  // Where a child's boundary lies in its parent; how deep the stack of leftovers gets.
  std::vector<std::vector<std::int32_t>> waiting(parts);
  for (std::size_t f = 0; f < parts; ++f) {
    Front& front = fronts_[f];
    for (const auto child : waiting[f]) {
      const Front& c = fronts_[static_cast<std::size_t>(child)];
      const std::int64_t b = c.size - c.pivots;
      stacked -= b * b;
    }
    const std::int64_t b = front.size - front.pivots;
    stacked += b * b;
    most_stacked = std::max(most_stacked, stacked);
    front.into_parent = static_cast<std::int64_t>(into_parent_.size());
    if (front.parent < 0) continue;
    waiting[static_cast<std::size_t>(front.parent)].push_back(static_cast<std::int32_t>(f));
    const Front& parent = fronts_[static_cast<std::size_t>(front.parent)];
    for (std::int32_t k = 0; k < parent.size; ++k)
      local[static_cast<std::size_t>(unknowns_[static_cast<std::size_t>(parent.unknowns + k)])] = k;
    for (std::int32_t k = front.pivots; k < front.size; ++k)
      into_parent_.push_back(
          local[static_cast<std::size_t>(unknowns_[static_cast<std::size_t>(front.unknowns + k)])]);
  }

  // Every entry belongs to the front that eliminates the earlier of its two unknowns.
  std::vector<std::int32_t> front_of(static_cast<std::size_t>(node_start.back())), turn_of(front_of.size());
  for (std::size_t node = 0; node < nodes; ++node) {
    for (auto u = node_start[node]; u < node_start[node + 1]; ++u) {
      front_of[static_cast<std::size_t>(u)] = part_of[node];
      turn_of[static_cast<std::size_t>(u)] = turn[node];
    }
  }
  std::vector<std::int64_t> count(parts + 1, 0);
  const auto owner = [&](const MatrixPlace& place) {
    const auto r = static_cast<std::size_t>(place.row), c = static_cast<std::size_t>(place.column);
    return static_cast<std::size_t>(turn_of[r] < turn_of[c] ? front_of[r] : front_of[c]);
  };
  for (const auto& place : places) ++count[owner(place) + 1];
  for (std::size_t f = 0; f < parts; ++f) count[f + 1] += count[f];
  entry_.resize(places.size());
  entry_row_.resize(places.size());
  entry_column_.resize(places.size());
  auto cursor = count;
  for (std::size_t k = 0; k < places.size(); ++k)
    entry_[static_cast<std::size_t>(cursor[owner(places[k])]++)] = static_cast<std::int32_t>(k);
  for (std::size_t f = 0; f < parts; ++f) {
    Front& front = fronts_[f];
    front.first_entry = count[f];
    front.last_entry = count[f + 1];
    for (std::int32_t k = 0; k < front.size; ++k)
      local[static_cast<std::size_t>(unknowns_[static_cast<std::size_t>(front.unknowns + k)])] = k;
    for (auto k = front.first_entry; k < front.last_entry; ++k) {
      const auto& place = places[static_cast<std::size_t>(entry_[static_cast<std::size_t>(k)])];
      entry_row_[static_cast<std::size_t>(k)] = local[static_cast<std::size_t>(place.row)];
      entry_column_[static_cast<std::size_t>(k)] = local[static_cast<std::size_t>(place.column)];
    }
  }
  columns_.resize(static_cast<std::size_t>(columns));
  rows_.resize(static_cast<std::size_t>(rows));
  swaps_.resize(static_cast<std::size_t>(swaps));
  front_.resize(static_cast<std::size_t>(largest * largest));
  stack_.resize(static_cast<std::size_t>(most_stacked));
  pivot_.resize(static_cast<std::size_t>(largest));
  boundary_.resize(static_cast<std::size_t>(largest));
}

void Multifrontal::factorise(const std::vector<double>& values) {
  const DenseKernels& dense = dense_kernels();
  // Leftovers in order of making: a front's children are the last ones on the stack.
  std::vector<std::int32_t> waiting;
  std::int64_t top = 0;
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    const Front& front = fronts_[f];
    const std::int64_t m = front.size, p = front.pivots, b = m - p;
    double* w = front_.data();
    std::fill(w, w + m * m, 0.0);
    for (auto k = front.first_entry; k < front.last_entry; ++k) {
      const auto at = static_cast<std::size_t>(k);
      w[entry_row_[at] + m * entry_column_[at]] += values[static_cast<std::size_t>(entry_[at])];
    }
    for (std::int32_t c = 0; c < front.children; ++c) {
      const Front& child = fronts_[static_cast<std::size_t>(waiting.back())];
      waiting.pop_back();
      const std::int64_t n = child.size - child.pivots;
      const std::int32_t* into = into_parent_.data() + child.into_parent;
      top -= n * n;
      const double* left = stack_.data() + top;
      for (std::int64_t column = 0; column < n; ++column) {
        double* to = w + m * into[column];
        for (std::int64_t row = 0; row < n; ++row) to[into[row]] += left[row + n * column];
      }
    }
    dense.factor_front(w, m, p, m, swaps_.data() + front.swaps);
    std::memcpy(columns_.data() + front.columns, w, static_cast<std::size_t>(m * p) * sizeof(double));
    for (std::int64_t c = 0; c < b; ++c) {
      std::memcpy(rows_.data() + front.rows + c * p, w + (p + c) * m,
                  static_cast<std::size_t>(p) * sizeof(double));
      std::memcpy(stack_.data() + top + c * b, w + (p + c) * m + p,
                  static_cast<std::size_t>(b) * sizeof(double));
    }
    top += b * b;
    if (front.parent >= 0) waiting.push_back(static_cast<std::int32_t>(f));
  }
}

void Multifrontal::solve(double* x) {
  const DenseKernels& dense = dense_kernels();
  double *pivot = pivot_.data(), *boundary = boundary_.data();
  for (const auto& front : fronts_) {
    const std::int32_t* unknown = unknowns_.data() + front.unknowns;
    const std::int32_t p = front.pivots, m = front.size;
    for (std::int32_t k = 0; k < p; ++k) pivot[k] = x[unknown[k]];
    std::fill(boundary, boundary + (m - p), 0.0);
    dense.forward(columns_.data() + front.columns, m, p, swaps_.data() + front.swaps, pivot, boundary);
    for (std::int32_t k = 0; k < p; ++k) x[unknown[k]] = pivot[k];
    for (std::int32_t k = p; k < m; ++k) x[unknown[k]] += boundary[k - p];
  }
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    const std::int32_t* unknown = unknowns_.data() + front->unknowns;
    const std::int32_t p = front->pivots, m = front->size;
    for (std::int32_t k = 0; k < p; ++k) pivot[k] = x[unknown[k]];
    for (std::int32_t k = p; k < m; ++k) boundary[k - p] = x[unknown[k]];
    dense.backward(columns_.data() + front->columns, rows_.data() + front->rows, m, p, pivot, boundary);
    for (std::int32_t k = 0; k < p; ++k) x[unknown[k]] = pivot[k];
  }
}

}  // namespace hfrac
