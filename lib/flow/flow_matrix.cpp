// SPDX-License-Identifier: BSD-3-Clause
#include "flow/flow_matrix.hpp"

#include <algorithm>
#include <atomic>

#include "core/give_back.hpp"

namespace hfrac {
namespace {

constexpr double joined_above =
    0.25;  // of what is stored; where multigrid leaves rows to its smoother (linear/aggregation.cpp)

}  // namespace

FlowMatrix::FlowMatrix(const Network& n, const std::vector<Pair>& joined, Layout layout, Workers* workers)
    : workers_(workers) {
  if (layout == Layout::nothing) return;
  const auto domains = n.kind.size();
  auto& start = rows_.start;
  start.assign(domains + 1, 0);
  const auto each_join = [&](const auto& visit) {
    for (std::size_t e = 0; e < n.left.size(); ++e)
      if (n.left[e] != n.right[e]) visit(n.left[e], n.right[e], static_cast<std::int32_t>(e));
    for (const auto& [i, j] : joined) visit(i, j, -1);
  };
  each_join([&](std::int32_t i, std::int32_t j, std::int32_t) {
    ++start[static_cast<std::size_t>(i) + 1];
    ++start[static_cast<std::size_t>(j) + 1];
  });
  for (std::size_t d = 0; d < domains; ++d) start[d + 1] += start[d];
  rows_.column.resize(static_cast<std::size_t>(start.back()));
  pipe_.resize(rows_.column.size());
  auto next = start;
  each_join([&](std::int32_t i, std::int32_t j, std::int32_t pipe) {
    const auto put = [&](std::int32_t row, std::int32_t column) {
      const auto at = next[static_cast<std::size_t>(row)]++;
      rows_.column[static_cast<std::size_t>(at)] = column;
      pipe_[static_cast<std::size_t>(at)] = pipe;
      return at;
    };
    const auto there = put(i, j), back = put(j, i);
    if (pipe < 0) place_of_pair_.emplace_back(there, back);
  });
  if (layout == Layout::lower) lay_out_lower();
}

void FlowMatrix::lay_out_lower() {
  const auto domains = rows_.start.size() - 1;
  std::vector<std::int32_t> entries(domains);
  const auto each_row = [&](const auto& visit) {  // visit(row, its first entry, one past its last)
    for (std::size_t d = 0; d < domains; ++d)
      visit(static_cast<std::int32_t>(d), static_cast<std::size_t>(rows_.start[d]),
            static_cast<std::size_t>(rows_.start[d + 1]));
  };
  std::vector<std::int32_t> below;
  const auto neighbours_below = [&](std::int32_t row, std::size_t first, std::size_t last) {
    below.clear();
    for (auto k = first; k < last; ++k)
      if (rows_.column[k] > row) below.push_back(rows_.column[k]);
    std::sort(below.begin(), below.end());
    below.erase(std::unique(below.begin(), below.end()), below.end());
  };
  each_row([&](std::int32_t row, std::size_t first, std::size_t last) {
    neighbours_below(row, first, last);
    entries[static_cast<std::size_t>(row)] = 1 + static_cast<std::int32_t>(below.size());
  });
  const auto size = static_cast<Eigen::Index>(domains);
  lower_.resize(size, size);
  lower_.reserve(entries);
  each_row([&](std::int32_t row, std::size_t first, std::size_t last) {
    neighbours_below(row, first, last);
    lower_.insert(row, row) = 1.0;
    for (const auto other : below) lower_.insert(other, row) = 1.0;
  });
  lower_.makeCompressed();
  lower_place_.assign(rows_.column.size(), -1);
  each_row([&](std::int32_t row, std::size_t first, std::size_t last) {
    const auto* begin = lower_.innerIndexPtr() + lower_.outerIndexPtr()[row];
    const auto* end = lower_.innerIndexPtr() + lower_.outerIndexPtr()[row + 1];
    for (auto k = first; k < last; ++k) {
      if (rows_.column[k] > row)
        lower_place_[k] =
            static_cast<std::int32_t>(std::lower_bound(begin, end, rows_.column[k]) - lower_.innerIndexPtr());
    }
  });
}

void FlowMatrix::assemble(const Network& n, double step, const std::vector<double>& source,
                          const Unknowns& unknowns, Eigen::VectorXd& rhs) {
  const auto domains = n.kind.size();
  rows_.value.resize(rows_.column.size());
  rows_.diagonal.resize(domains);
  rhs.resize(static_cast<Eigen::Index>(domains));
  const auto solved = [&](std::size_t d) { return n.stiffness[d] > 0.0 && !unknowns.cavitated[d]; };
  const auto imposed = [&](std::size_t d) { return n.stiffness[d] > 0.0 ? n.floor_pressure : n.pressure[d]; };
  share(domains, [&](std::size_t from, std::size_t to) {
    for (auto d = from; d < to; ++d) {
      const auto first = static_cast<std::size_t>(rows_.start[d]),
                 last = static_cast<std::size_t>(rows_.start[d + 1]);
      double &diagonal = rows_.diagonal[d], &right = rhs[static_cast<Eigen::Index>(d)];
      if (!solved(d)) {
        diagonal = unknowns.imposed_weight;
        right = unknowns.imposed_weight * imposed(d);
        for (auto k = first; k < last; ++k) rows_.value[k] = 0.0;
        continue;
      }
      double sum = 1.0 / n.stiffness[d],
             fed = n.full_pressure(d) / n.stiffness[d] + (source.empty() ? 0.0 : step * source[d]);
      for (auto k = first; k < last; ++k) {
        const auto pipe = pipe_[k];
        const auto other = static_cast<std::size_t>(rows_.column[k]);
        const double c = pipe < 0 ? 0.0 : step * n.conductance[pipe];
        sum += c;
        const bool both = solved(other);
        rows_.value[k] = both ? 0.0 - c : 0.0;
        if (!both && c != 0.0) fed += c * imposed(other);
      }
      diagonal = sum;
      right = fed;
    }
  });
}

void FlowMatrix::add_to_pair(std::size_t pair, double value) {
  for (const auto at : {place_of_pair_[pair].first, place_of_pair_[pair].second})
    rows_.value[static_cast<std::size_t>(at)] += value;
}

const SparseMatrix& FlowMatrix::lower() {
  double* value = lower_.valuePtr();
  // A column has what stands right of the diagonal in its row; several pipes may join two domains.
  const auto* start = lower_.outerIndexPtr();
  share(rows_.diagonal.size(), [&](std::size_t from, std::size_t to) {
    for (auto d = from; d < to; ++d) {
      std::fill(value + start[d], value + start[d + 1], 0.0);
      value[start[d]] = rows_.diagonal[d];
      for (auto k = static_cast<std::size_t>(rows_.start[d]);
           k < static_cast<std::size_t>(rows_.start[d + 1]); ++k)
        if (lower_place_[k] >= 0) value[lower_place_[k]] += rows_.value[k];
    }
  });
  return lower_;
}

void FlowMatrix::forget_values() {
  give_back(rows_.value);
  give_back(rows_.diagonal);
}

void FlowMatrix::add_up_flows(const Network& n, double step, std::vector<double>& gain) const {
  gain.resize(n.kind.size());
  share(gain.size(), [&](std::size_t from, std::size_t to) {
    for (auto d = from; d < to; ++d) {
      double sum = 0.0;
      for (auto k = static_cast<std::size_t>(rows_.start[d]);
           k < static_cast<std::size_t>(rows_.start[d + 1]); ++k) {
        if (pipe_[k] < 0) continue;
        const double moved = step * n.flow[pipe_[k]];
        sum += n.left[static_cast<std::size_t>(pipe_[k])] == static_cast<std::int32_t>(d) ? -moved : moved;
      }
      gain[d] = sum;
    }
  });
}

std::int64_t FlowMatrix::joined(const Network& n, double step) const {
  std::atomic<std::int64_t> all{0};
  share(n.kind.size(), [&](std::size_t from, std::size_t to) {
    std::int64_t here = 0;
    for (auto d = from; d < to; ++d) {
      if (n.stiffness[d] <= 0.0) continue;
      double conducted = 0.0;
      for (auto k = static_cast<std::size_t>(rows_.start[d]);
           k < static_cast<std::size_t>(rows_.start[d + 1]); ++k)
        if (pipe_[k] >= 0) conducted += step * n.conductance[pipe_[k]];
      here += conducted * n.stiffness[d] > joined_above ? 1 : 0;
    }
    all += here;
  });
  return all;
}

double FlowMatrix::outflow(const Network& n, std::int32_t domain) const {
  double sum = 0.0;
  const auto add = [&](std::size_t pipe) {
    if (n.left[pipe] == domain) sum += n.flow[pipe];
    if (n.right[pipe] == domain) sum -= n.flow[pipe];
  };
  if (rows_.start.empty()) {
    for (std::size_t pipe = 0; pipe < n.left.size(); ++pipe) add(pipe);
    return sum;
  }
  const auto d = static_cast<std::size_t>(domain);
  for (auto k = static_cast<std::size_t>(rows_.start[d]); k < static_cast<std::size_t>(rows_.start[d + 1]);
       ++k)
    if (pipe_[k] >= 0) add(static_cast<std::size_t>(pipe_[k]));
  return sum;
}

}  // namespace hfrac
