// SPDX-License-Identifier: BSD-3-Clause
#include "linear/multifrontal.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

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
constexpr std::int64_t kernel_rows = 32;

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
  fit(top_, FrontTree::height(tree.largest_above) * tree.largest_above);
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

// What a factor is made in goes before the vectors of GMRES come.
template <class Real>
void Multifrontal<Real>::tidy() {
  give_back(kept_);
  give_back(top_);
  for (auto& bench : benches_) {
    give_back(bench.front);
    give_back(bench.stack);
  }
}

// Columns [first, last) of a front.
template <class Real>
void Multifrontal<Real>::assemble(const FrontTree& tree, const Front& front, const std::vector<Real>& values,
                                  Real* w, Bench& bench, std::int64_t first, std::int64_t last) {
  const std::int64_t ld = FrontTree::height(front.size);
  std::fill(w + first * ld, w + last * ld, Real(0));
  for (auto k = front.first_entry; k < front.last_entry; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const std::int64_t place = tree.entry_place[at];
    if (place < first * ld || place >= last * ld) continue;
    w[place] += values[static_cast<std::size_t>(tree.entry[at])];
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
                                         const std::vector<Real>& values, Bench& bench) {
  const std::int64_t m = front.size;
  Real* w = bench.front.data();
  assemble(tree, front, values, w, bench, 0, m);
  dense_->factor_front(w, m, front.pivots, FrontTree::height(m), swaps_.data() + front.swaps);
  store(front, w, leftover(front, bench), 0, m);
}

template <class Real>
void Multifrontal<Real>::factorise_top(const FrontTree& tree, const Front& front,
                                       const std::vector<Real>& values, Workers& workers, int worker) {
  const std::int64_t m = front.size, p = front.pivots, ld = FrontTree::height(m);
  Bench& bench = benches_[static_cast<std::size_t>(worker)];
  Real* w = top_.data();
  const auto all = workers.part(worker, m, kernel_rows);
  assemble(tree, front, values, w, bench, all.first, all.last);
  workers.barrier();
  for (std::int64_t begin = 0; begin < p; begin += dense_panel) {
    const std::int64_t end = std::min(begin + dense_panel, p);
    if (worker == 0) dense_->factor_panel(w, m, p, ld, begin, end, swaps_.data() + front.swaps);
    workers.barrier();
    const auto right = workers.part(worker, m - end, kernel_rows);
    dense_->update(w, m, ld, begin, end, end + right.first, end + right.last);
    workers.barrier();
  }
  store(front, w, leftover(front, bench), all.first, all.last);
  workers.barrier();
}

template <class Real>
template <class Words>
void Multifrontal<Real>::talk(Workers& workers, int worker, const Ranks& ranks, const Words& words) {
  if (ranks.alone()) return;
  if (worker == 0 && !failure_) {
    try {
      words();
    } catch (...) {
      failure_ = std::current_exception();
    }
  }
  workers.barrier();
}

// From the owners of a front's children to its own; place(child): where it stands, on both, and how many numbers.
template <class Real>
template <class Place>
void Multifrontal<Real>::hand_up(const FrontTree& tree, const Front& front, const Ranks& ranks,
                                 const Place& place) {
  for (const auto number : front.child) {
    if (number < 0) continue;
    const Front& child = tree.fronts[static_cast<std::size_t>(number)];
    const bool sends = child.owner == ranks.rank(), receives = front.owner == ranks.rank();
    if (sends == receives) continue;
    const auto [at, count] = place(child);
    const auto bytes = count * static_cast<std::int64_t>(sizeof(Real));
    if (bytes == 0) continue;
    const Message message = sends ? Message{front.owner, 0, bytes, 0, at, nullptr}
                                  : Message{child.owner, 0, 0, bytes, nullptr, at};
    ranks.start({&message, 1});
    ranks.finish();
  }
}

// The unknowns of a front, to all.
template <class Real>
void Multifrontal<Real>::tell_solved(const FrontTree& tree, const Front& front, const Ranks& ranks) {
  const std::int32_t* unknown = tree.unknowns.data() + front.unknowns;
  Real* values = benches_[0].pivots.data();
  for (std::int32_t k = 0; front.owner == ranks.rank() && k < front.pivots; ++k)
    values[k] = solution_[static_cast<std::size_t>(unknown[k])];
  std::vector<std::int64_t> begin(static_cast<std::size_t>(ranks.size()) + 1, 0);
  std::fill(begin.begin() + front.owner + 1, begin.end(), front.pivots);
  ranks.gather(values, std::move(begin));
  for (std::int32_t k = 0; k < front.pivots; ++k) solution_[static_cast<std::size_t>(unknown[k])] = values[k];
}

template <class Real>
void Multifrontal<Real>::tell_all_solved(const FrontTree& tree, const Ranks& ranks) {
  std::vector<Real> values(static_cast<std::size_t>(tree.unknown_count));
  const auto each = [&](const auto& visit) {
    auto at = tree.solved;
    for (const Front& front : tree.fronts) {
      const std::int32_t* unknown = tree.unknowns.data() + front.unknowns;
      auto& place = at[static_cast<std::size_t>(front.owner)];
      for (std::int32_t k = 0; k < front.pivots; ++k, ++place)
        visit(front, values[static_cast<std::size_t>(place)],
              solution_[static_cast<std::size_t>(unknown[k])]);
    }
  };
  each([&](const Front& front, Real& value, const Real& solved) {
    if (front.owner == ranks.rank()) value = solved;
  });
  ranks.gather(values.data(), tree.solved);
  each([](const Front&, const Real& value, Real& solved) { solved = value; });
}

template <class Real>
void Multifrontal<Real>::factorise(const FrontTree& tree, const std::vector<Real>& values, Workers& workers,
                                   const Ranks& ranks) {
  prepare(tree, workers);
  next_ = 0;
  failure_ = nullptr;
  const auto task = [&](int worker) {
    Bench& bench = benches_[static_cast<std::size_t>(worker)];
    each_subtree(tree, next_, [&](const auto& subtree) {
      for (auto f = subtree.first; f < subtree.last; ++f)
        factorise_below(tree, tree.fronts[static_cast<std::size_t>(f)], values, bench);
    });
    if (tree.top.empty()) return;
    workers.barrier();
    for (const auto f : tree.top) {
      const Front& front = tree.fronts[static_cast<std::size_t>(f)];
      talk(workers, worker, ranks, [&] {
        hand_up(tree, front, ranks, [&](const Front& child) {
          const std::int64_t b = child.size - child.pivots;
          return std::pair(leftover(child, bench), b * b);
        });
      });
      if (front.owner == ranks.rank()) factorise_top(tree, front, values, workers, worker);
    }
  };
  if (tree.top.empty())
    task(0);
  else
    workers.run(task, false);
  tidy();
  if (failure_) std::rethrow_exception(failure_);
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
  const auto mine = workers.part(worker, m - p, kernel_rows);
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
  const auto mine = workers.part(worker, p, kernel_rows);
  dense_->right(rows_.data() + front.rows, p, m - p, boundary, pivots, mine.first, mine.last);
  workers.barrier();
  if (worker != 0) return;
  dense_->backward(columns_.data() + front.columns, m, p, pivots);
  for (std::int64_t k = 0; k < p; ++k) solution_[static_cast<std::size_t>(unknown[k])] = pivots[k];
}

template <class Real>
void Multifrontal<Real>::solve(const FrontTree& tree, double* x, Workers& workers, const Ranks& ranks) {
  next_ = 0;
  failure_ = nullptr;
  std::atomic<std::int32_t> back{0};
  const auto task = [&](int worker) {
    Bench& bench = benches_[static_cast<std::size_t>(worker)];
    each_subtree(tree, next_, [&](const auto& subtree) {
      for (auto f = subtree.first; f < subtree.last; ++f)
        forward_below(tree, tree.fronts[static_cast<std::size_t>(f)], x, bench);
    });
    if (!tree.top.empty()) {
      workers.barrier();
      for (const auto f : tree.top) {
        const Front& front = tree.fronts[static_cast<std::size_t>(f)];
        talk(workers, worker, ranks, [&] {
          hand_up(tree, front, ranks, [&](const Front& child) {
            return std::pair(carried_.data() + child.carried,
                             static_cast<std::int64_t>(child.size - child.pivots));
          });
        });
        if (front.owner == ranks.rank()) forward_top(tree, front, x, workers, worker);
      }
      for (auto f = tree.top.rbegin(); f != tree.top.rend(); ++f) {
        const Front& front = tree.fronts[static_cast<std::size_t>(*f)];
        if (front.owner == ranks.rank()) backward_top(tree, front, workers, worker);
        talk(workers, worker, ranks, [&] { tell_solved(tree, front, ranks); });
      }
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
  if (failure_) std::rethrow_exception(failure_);
  if (!ranks.alone()) tell_all_solved(tree, ranks);
  for (std::size_t k = 0; k < solution_.size(); ++k) x[k] = static_cast<double>(solution_[k]);
}

template class Multifrontal<float>;
template class Multifrontal<double>;

}  // namespace hfrac
