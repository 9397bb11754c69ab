// SPDX-License-Identifier: BSD-3-Clause
#include "linear/multifrontal.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "core/give_back.hpp"

namespace hfrac {
namespace {

template <class Real>
const DenseKernels<Real>* kernels() {
  if constexpr (std::is_same_v<Real, float>)
    return &dense_kernels().single_precision;
  else
    return &dense_kernels().double_precision;
}

// A worker's part of `count` columns or rows, in whole vectors of the kernels.
constexpr std::int64_t grain = 32;

// Subtrees, one after the other as `next` hands them out; what other workers take is left out.
template <class Visit>
void each_subtree(const FrontTree& tree, std::atomic<std::int32_t>& next, const Visit& visit) {
  const auto subtrees = static_cast<std::int32_t>(tree.subtrees.size());
  for (auto t = next.fetch_add(1); t < subtrees; t = next.fetch_add(1))
    visit(tree.subtrees[static_cast<std::size_t>(t)]);
}

}  // namespace

template <class Real>
Multifrontal<Real>& Multifrontal<Real>::operator=(Multifrontal&& other) noexcept {
  dense_ = other.dense_;
  columns_ = std::move(other.columns_);
  rows_ = std::move(other.rows_);
  kept_ = std::move(other.kept_);
  top_ = std::move(other.top_);
  carried_ = std::move(other.carried_);
  solution_ = std::move(other.solution_);
  swaps_ = std::move(other.swaps_);
  benches_ = std::move(other.benches_);
  return *this;
}

template <class Real>
void Multifrontal<Real>::prepare(const FrontTree& tree, const Workers& workers) {
  const auto fit = [](auto& array, std::int64_t size) {
    if (array.size() != static_cast<std::size_t>(size)) {
      give_back(array);
      array.resize(static_cast<std::size_t>(size));
    }
  };
  dense_ = kernels<Real>();
  fit(columns_, tree.columns + dense_slack);
  fit(rows_, tree.rows + dense_slack);
  fit(kept_, tree.kept);
  fit(top_, tree.top.empty() ? 0 : FrontTree::height(tree.largest) * tree.largest);
  fit(carried_, tree.carried);
  fit(solution_, tree.unknown_count);
  fit(swaps_, tree.swaps);
  benches_.resize(static_cast<std::size_t>(workers.count()));
  for (auto& bench : benches_) {
    fit(bench.front, FrontTree::height(tree.largest_below) * tree.largest_below);
    fit(bench.stack, tree.stacked);
    fit(bench.pivots, tree.largest + dense_slack);
    fit(bench.boundary, tree.largest + dense_slack);
  }
}

// Columns [first, last) of a front.
template <class Real>
void Multifrontal<Real>::assemble(const FrontTree& tree, const Front& front,
                                  const std::vector<double>& values, Real* w, Bench& bench,
                                  std::int64_t first, std::int64_t last) {
  const std::int64_t ld = FrontTree::height(front.size);
  std::fill(w + first * ld, w + last * ld, Real(0));
  for (auto k = front.first_entry; k < front.last_entry; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const auto column = tree.entry_column[at];
    if (column < first || column >= last) continue;
    w[tree.entry_row[at] + ld * column] +=
        static_cast<Real>(values[static_cast<std::size_t>(tree.entry[at])]);
  }
  for (const auto number : front.child) {
    if (number < 0) continue;
    const Front& child = tree.fronts[static_cast<std::size_t>(number)];
    const std::int64_t n = child.size - child.pivots;
    const std::int32_t* into = tree.into_parent.data() + child.into_parent;
    const Real* left = leftover(child, bench);
    for (std::int64_t column = 0; column < n; ++column) {
      if (into[column] < first || into[column] >= last) continue;
      Real* to = w + ld * into[column];
      for (std::int64_t row = 0; row < n; ++row) to[into[row]] += left[row + n * column];
    }
  }
}

template <class Real>
void Multifrontal<Real>::store(const Front& front, const Real* w, Real* left, std::int64_t first,
                               std::int64_t last) {
  const std::int64_t m = front.size, p = front.pivots, b = m - p, ld = FrontTree::height(m);
  const auto bytes = [](std::int64_t count) { return static_cast<std::size_t>(count) * sizeof(Real); };
  for (std::int64_t c = first; c < std::min(last, p); ++c)
    std::memcpy(columns_.data() + front.columns + c * m, w + c * ld, bytes(m));
  for (std::int64_t c = std::max(first, p); c < last; ++c) {
    std::memcpy(rows_.data() + front.rows + (c - p) * p, w + c * ld, bytes(p));
    std::memcpy(left + (c - p) * b, w + c * ld + p, bytes(b));
  }
}

template <class Real>
void Multifrontal<Real>::factorise_below(const FrontTree& tree, const Front& front,
                                         const std::vector<double>& values, Bench& bench) {
  const std::int64_t m = front.size;
  Real* w = bench.front.data();
  assemble(tree, front, values, w, bench, 0, m);
  dense_->factor_front(w, m, front.pivots, FrontTree::height(m), swaps_.data() + front.swaps);
  store(front, w, leftover(front, bench), 0, m);
}

template <class Real>
void Multifrontal<Real>::factorise_top(const FrontTree& tree, const Front& front,
                                       const std::vector<double>& values, Workers& workers, int worker) {
  const std::int64_t m = front.size, p = front.pivots, ld = FrontTree::height(m);
  Bench& bench = benches_[static_cast<std::size_t>(worker)];
  Real* w = top_.data();
  const auto all = workers.part(worker, m, grain);
  assemble(tree, front, values, w, bench, all.first, all.last);
  workers.barrier();
  for (std::int64_t begin = 0; begin < p; begin += dense_panel) {
    const std::int64_t end = std::min(begin + dense_panel, p);
    if (worker == 0) dense_->factor_panel(w, m, p, ld, begin, end, swaps_.data() + front.swaps);
    workers.barrier();
    const auto right = workers.part(worker, m - end, grain);
    dense_->update(w, m, ld, begin, end, end + right.first, end + right.last);
    workers.barrier();
  }
  store(front, w, leftover(front, bench), all.first, all.last);
  workers.barrier();
}

template <class Real>
void Multifrontal<Real>::factorise(const FrontTree& tree, const std::vector<double>& values,
                                   Workers& workers) {
  prepare(tree, workers);
  next_ = 0;
  const auto task = [&](int worker) {
    Bench& bench = benches_[static_cast<std::size_t>(worker)];
    each_subtree(tree, next_, [&](const auto& subtree) {
      for (auto f = subtree.first; f < subtree.last; ++f)
        factorise_below(tree, tree.fronts[static_cast<std::size_t>(f)], values, bench);
    });
    if (tree.top.empty()) return;
    workers.barrier();
    for (const auto f : tree.top)
      factorise_top(tree, tree.fronts[static_cast<std::size_t>(f)], values, workers, worker);
  };
  if (tree.top.empty())
    task(0);
  else
    workers.run(task, false);
}

// Right side of a front: its own, and what its children handed up.
template <class Real>
void Multifrontal<Real>::gather(const FrontTree& tree, const Front& front, const double* x, Real* pivots,
                                Real* boundary) const {
  const std::int32_t* unknown = tree.unknowns.data() + front.unknowns;
  const std::int32_t p = front.pivots, m = front.size;
  for (std::int32_t k = 0; k < p; ++k) pivots[k] = static_cast<Real>(x[unknown[k]]);
  std::fill(boundary, boundary + (m - p), Real(0));
  for (const auto number : front.child) {
    if (number < 0) continue;
    const Front& child = tree.fronts[static_cast<std::size_t>(number)];
    const std::int32_t* into = tree.into_parent.data() + child.into_parent;
    const Real* carried = carried_.data() + child.carried;
    for (std::int32_t k = 0; k < child.size - child.pivots; ++k)
      (into[k] < p ? pivots[into[k]] : boundary[into[k] - p]) += carried[k];
  }
}

template <class Real>
void Multifrontal<Real>::forward_below(const FrontTree& tree, const Front& front, const double* x,
                                       Bench& bench) {
  const std::int64_t p = front.pivots, m = front.size;
  const Real* columns = columns_.data() + front.columns;
  Real *pivots = bench.pivots.data(), *boundary = carried_.data() + front.carried;
  gather(tree, front, x, pivots, boundary);
  dense_->forward(columns, m, p, swaps_.data() + front.swaps, pivots);
  dense_->below(columns, m, p, pivots, boundary, 0, m - p);
  const std::int32_t* unknown = tree.unknowns.data() + front.unknowns;
  for (std::int64_t k = 0; k < p; ++k) solution_[static_cast<std::size_t>(unknown[k])] = pivots[k];
}

template <class Real>
void Multifrontal<Real>::forward_top(const FrontTree& tree, const Front& front, const double* x,
                                     Workers& workers, int worker) {
  const std::int64_t p = front.pivots, m = front.size;
  const Real* columns = columns_.data() + front.columns;
  Real *pivots = benches_[0].pivots.data(), *boundary = carried_.data() + front.carried;
  if (worker == 0) {
    gather(tree, front, x, pivots, boundary);
    dense_->forward(columns, m, p, swaps_.data() + front.swaps, pivots);
    const std::int32_t* unknown = tree.unknowns.data() + front.unknowns;
    for (std::int64_t k = 0; k < p; ++k) solution_[static_cast<std::size_t>(unknown[k])] = pivots[k];
  }
  workers.barrier();
  const auto mine = workers.part(worker, m - p, grain);
  dense_->below(columns, m, p, pivots, boundary, mine.first, mine.last);
  workers.barrier();
}

template <class Real>
void Multifrontal<Real>::backward_below(const FrontTree& tree, const Front& front, Bench& bench) {
  const std::int64_t p = front.pivots, m = front.size;
  const std::int32_t* unknown = tree.unknowns.data() + front.unknowns;
  Real *pivots = bench.pivots.data(), *boundary = bench.boundary.data();
  for (std::int64_t k = 0; k < p; ++k) pivots[k] = solution_[static_cast<std::size_t>(unknown[k])];
  for (std::int64_t k = p; k < m; ++k) boundary[k - p] = solution_[static_cast<std::size_t>(unknown[k])];
  dense_->right(rows_.data() + front.rows, p, m - p, boundary, pivots, 0, p);
  dense_->backward(columns_.data() + front.columns, m, p, pivots);
  for (std::int64_t k = 0; k < p; ++k) solution_[static_cast<std::size_t>(unknown[k])] = pivots[k];
}

template <class Real>
void Multifrontal<Real>::backward_top(const FrontTree& tree, const Front& front, Workers& workers,
                                      int worker) {
  const std::int64_t p = front.pivots, m = front.size;
  const std::int32_t* unknown = tree.unknowns.data() + front.unknowns;
  Real *pivots = benches_[0].pivots.data(), *boundary = benches_[0].boundary.data();
  if (worker == 0) {
    for (std::int64_t k = 0; k < p; ++k) pivots[k] = solution_[static_cast<std::size_t>(unknown[k])];
    for (std::int64_t k = p; k < m; ++k) boundary[k - p] = solution_[static_cast<std::size_t>(unknown[k])];
  }
  workers.barrier();
  const auto mine = workers.part(worker, p, grain);
  dense_->right(rows_.data() + front.rows, p, m - p, boundary, pivots, mine.first, mine.last);
  workers.barrier();
  if (worker != 0) return;
  dense_->backward(columns_.data() + front.columns, m, p, pivots);
  for (std::int64_t k = 0; k < p; ++k) solution_[static_cast<std::size_t>(unknown[k])] = pivots[k];
}

template <class Real>
void Multifrontal<Real>::solve(const FrontTree& tree, double* x, Workers& workers) {
  next_ = 0;
  std::atomic<std::int32_t> back{0};
  const auto task = [&](int worker) {
    Bench& bench = benches_[static_cast<std::size_t>(worker)];
    each_subtree(tree, next_, [&](const auto& subtree) {
      for (auto f = subtree.first; f < subtree.last; ++f)
        forward_below(tree, tree.fronts[static_cast<std::size_t>(f)], x, bench);
    });
    if (!tree.top.empty()) {
      workers.barrier();
      for (const auto f : tree.top)
        forward_top(tree, tree.fronts[static_cast<std::size_t>(f)], x, workers, worker);
      for (auto f = tree.top.rbegin(); f != tree.top.rend(); ++f)
        backward_top(tree, tree.fronts[static_cast<std::size_t>(*f)], workers, worker);
      workers.barrier();
    }
    each_subtree(tree, back, [&](const auto& subtree) {
      for (auto f = subtree.last; f-- > subtree.first;)
        backward_below(tree, tree.fronts[static_cast<std::size_t>(f)], bench);
    });
  };
  if (tree.top.empty())
    task(0);
  else
    workers.run(task, false);
  for (std::size_t k = 0; k < solution_.size(); ++k) x[k] = static_cast<double>(solution_[k]);
}

template class Multifrontal<float>;
template class Multifrontal<double>;

}  // namespace hfrac
