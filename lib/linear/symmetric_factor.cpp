// SPDX-License-Identifier: BSD-3-Clause
#include "linear/symmetric_factor.hpp"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <atomic>
#include <numeric>

#include "core/workers.hpp"

namespace hfrac {
namespace {

// Numbers of a piece, columns times rows, from which the dense kernels are quicker than a plain loop.
constexpr std::int64_t worth_kernels = 24;
// Numbers changed in all from which workers make a factor sooner than one.
constexpr double worth_sharing = 2e5;

std::size_t at(std::int64_t k) {
  return static_cast<std::size_t>(k);
}

}  // namespace

void SymmetricFactor::order(const SparseMatrix& lower) {
  const auto n = static_cast<std::int32_t>(lower.cols());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> turn;  // which row stands here
  {
    SparseMatrix
        both;  // made first: one that runs out of memory while it is made would keep what it got so far
    both = lower.selfadjointView<Eigen::Lower>();
    Eigen::AMDOrdering<int>()(both, turn);
  }
  place_.resize(at(n));
  for (std::int32_t k = 0; k < n; ++k) place_[at(turn.indices()[k])] = k;
  entry_start_.assign(at(n) + 1, 0);
  const auto each_entry = [&](const auto& visit) {
    for (std::int32_t j = 0; j < n; ++j) {
      for (auto e = lower.outerIndexPtr()[j]; e < lower.outerIndexPtr()[j + 1]; ++e) {
        const auto i = lower.innerIndexPtr()[e];
        if (i >= j) visit(std::minmax(place_[at(i)], place_[at(j)]), e);
      }
    }
  };
  each_entry([&](const auto& ends, int) { ++entry_start_[at(ends.second) + 1]; });
  std::partial_sum(entry_start_.begin(), entry_start_.end(), entry_start_.begin());
  entry_column_.resize(at(entry_start_.back()));
  entry_value_.resize(entry_column_.size());
  auto cursor = entry_start_;
  each_entry([&](const auto& ends, int e) {
    const auto to = at(cursor[at(ends.second)]++);
    entry_column_[to] = ends.first;
    entry_value_[to] = e;
  });
}

void SymmetricFactor::analyse(const SparseMatrix& lower) {
  order(lower);
  const auto n = static_cast<std::int32_t>(place_.size());
  // Elimination tree and rows below each column's diagonal (Liu 1990, SIAM J. Matrix Anal. Appl. 11, 134-172).
  std::vector<std::int32_t> parent(at(n), -1), count(at(n), 0), seen(at(n), -1);
  for (std::int32_t k = 0; k < n; ++k) {
    seen[at(k)] = k;
    for (auto e = entry_start_[at(k)]; e < entry_start_[at(k) + 1]; ++e) {
      for (auto i = entry_column_[at(e)]; seen[at(i)] != k; i = parent[at(i)]) {
        if (parent[at(i)] < 0) parent[at(i)] = k;
        ++count[at(i)];
        seen[at(i)] = k;
      }
    }
  }
  find_blocks(parent, count);
  find_pieces(parent);
}

void SymmetricFactor::find_blocks(const std::vector<std::int32_t>& parent,
                                  const std::vector<std::int32_t>& count) {
  const auto n = static_cast<std::int32_t>(place_.size());
  blocks_.clear();
  std::int64_t values = 0, below = 0;
  std::int32_t widest = 0, longest = 0;
  for (std::int32_t first = 0, last = 0; first < n; first = last) {
    for (last = first + 1;
         last < n && parent[at(last) - 1] == last && count[at(last) - 1] == count[at(last)] + 1;)
      ++last;
    const std::int32_t columns = last - first, rows = columns + count[at(last) - 1];
    blocks_.push_back({first, last, rows, 0, values, below});
    values += std::int64_t{columns} * rows;
    below += count[at(last) - 1];
    widest = std::max(widest, columns);
    longest = std::max(longest, rows);
  }
  below_.resize(at(below));
  // The kernels touch up to dense_slack rows behind the last one.
  value_.assign(at(values + dense_slack), 0.0);
  pivot_.resize(at(n));
  benches_.resize(1);
  benches_[0].row.assign(at(n + dense_slack), 0.0);
  benches_[0].gathered.assign(at(longest + dense_slack), 0.0);
  no_swaps_.resize(at(widest));
  std::iota(no_swaps_.begin(), no_swaps_.end(), 0);
}

// The columns that row k of L has, in the order in which the plain algorithm comes to them: what an entry of the matrix reaches going up the
// tree stands before what entries before it did.
void SymmetricFactor::find_pieces(const std::vector<std::int32_t>& parent) {
  const auto n = static_cast<std::int32_t>(place_.size());
  std::vector<std::int32_t> seen(at(n), -1), reached(at(n)), way;
  std::vector<double> work(at(n), 1.0);
  block_of_.resize(at(n));
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    std::fill(block_of_.begin() + blocks_[b].first, block_of_.begin() + blocks_[b].last,
              static_cast<std::int32_t>(b));
  pieces_.clear();
  piece_start_.assign(1, 0);
  for (std::int32_t k = 0; k < n; ++k) {
    seen[at(k)] = k;
    auto top = n;
    for (auto e = entry_start_[at(k)]; e < entry_start_[at(k) + 1]; ++e) {
      way.clear();
      for (auto i = entry_column_[at(e)]; seen[at(i)] != k; i = parent[at(i)]) {
        seen[at(i)] = k;
        way.push_back(i);
      }
      top -= static_cast<std::int32_t>(way.size());
      std::copy(way.begin(), way.end(), reached.begin() + top);
    }
    for (; top < n; ++top) {
      const auto i = reached[at(top)], b = block_of_[at(i)];
      if (static_cast<std::int64_t>(pieces_.size()) > piece_start_.back() && pieces_.back().last == i &&
          block_of_[at(pieces_.back().first)] == b)
        ++pieces_.back().last;
      else
        pieces_.push_back({i, i + 1});
      Block& block = blocks_[at(b)];
      if (i + 1 == block.last && k >= block.last) below_[at(block.below + block.filled++)] = k;
      work[at(k)] += block.last - i + block.filled;
    }
    piece_start_.push_back(static_cast<std::int64_t>(pieces_.size()));
  }
  subtrees_.cut(parent, work);
}

// The row at hand less what the piece's columns do to it; their own values become row k of L. Returns the pivot less their share.
inline double SymmetricFactor::take_piece(const Piece& piece, std::int32_t k, double pivot, Bench& bench) {
  Block& block = blocks_[at(block_of_[at(piece.first)])];
  const std::int64_t ld = block.rows, columns = piece.last - piece.first;
  const bool inside = k < block.last;
  // Rows before row k from the piece's first column on: `own` among the block's columns, then `below`, which begin at row `low` of it.
  const std::int64_t own = (inside ? k : block.last) - piece.first, below = inside ? 0 : block.filled,
                     low = block.last - piece.first;
  double* corner = value_.data() + block.value + (piece.first - block.first) * (ld + 1);
  double* row = bench.row.data();
  double* x = row + piece.first;
  const std::int32_t* rows = below_.data() + block.below;
  for (std::int64_t c = 0; c < columns; ++c) x[c] = unless_negligible(x[c]);
  if (columns < 2 || columns * (columns + below) < worth_kernels) {
    for (std::int64_t c = 0; c < columns; ++c) {
      const double* column = corner + c * ld;
      const double factor = x[c];
      for (std::int64_t r = c + 1; r < own; ++r) x[r] -= column[r] * factor;
      for (std::int64_t r = 0; r < below; ++r) row[rows[r]] -= column[low + r] * factor;
    }
  } else {
    // The kernel also touches what stands behind the columns.
    double behind[dense_slack];
    for (std::int64_t s = 0; s < dense_slack; ++s) behind[s] = x[columns + s];
    kernels_.forward(corner, ld, columns, no_swaps_.data(), x);
    for (std::int64_t s = 0; s < dense_slack; ++s) x[columns + s] = behind[s];
    for (std::int64_t c = 0; columns < own && c < columns; ++c) {
      for (std::int64_t r = columns; r < own; ++r) x[r] -= corner[r + c * ld] * x[c];
    }
    double* gathered = bench.gathered.data();
    for (std::int64_t r = 0; r < below; ++r) gathered[r] = row[rows[r]];
    kernels_.below(corner + (low - columns), ld, columns, x, gathered, 0, below);
    for (std::int64_t r = 0; r < below; ++r) row[rows[r]] = gathered[r];
  }
  double* to = corner + (inside ? own : low + below);
  const double* diagonal = pivot_.data() + piece.first;
  for (std::int64_t c = 0; c < columns; ++c) {
    const double value = x[c], l = unless_negligible(value / diagonal[c]);
    x[c] = 0.0;
    pivot -= l * value;
    to[c * ld] = l;
  }
  block.filled += !inside && piece.last == block.last ? 1 : 0;
  return pivot;
}

inline bool SymmetricFactor::make_row(std::int32_t row, const double* given, Bench& bench) {
  const auto k = at(row);
  for (auto e = entry_start_[k]; e < entry_start_[k + 1]; ++e)
    bench.row[at(entry_column_[at(e)])] += given[entry_value_[at(e)]];
  double pivot = bench.row[k];
  bench.row[k] = 0.0;
  for (auto p = piece_start_[k]; p < piece_start_[k + 1]; ++p)
    pivot = take_piece(pieces_[at(p)], row, pivot, bench);
  pivot_[k] = pivot;
  return pivot != 0.0;
}

bool SymmetricFactor::factorise(const SparseMatrix& lower, Workers* workers) {
  const double* given = lower.valuePtr();
  for (Block& block : blocks_) block.filled = 0;
  succeeded_ = false;
  std::atomic<bool> sound{true};
  const auto make_rows = [&](Bench& bench) {
    std::fill(bench.row.begin(), bench.row.end(), 0.0);
    subtrees_.take([&](std::int32_t row) {
      if (sound.load(std::memory_order_relaxed) && !make_row(row, given, bench)) sound = false;
    });
  };
  subtrees_.begin();
  if (workers != nullptr && workers->count() > 1 && !workers->forked() && subtrees_.work() > worth_sharing) {
    benches_.resize(at(workers->count()), benches_.front());
    workers->run([&](int worker) { make_rows(benches_[at(worker)]); }, false);
  } else {
    make_rows(benches_.front());
  }
  return succeeded_ = sound;
}

void SymmetricFactor::forward(double* x) const {
  for (const Block& block : blocks_) {
    const std::int32_t own = block.columns();
    const std::int32_t* rows = below_.data() + block.below;
    for (std::int32_t c = 0; c < own; ++c) {
      const double* column = value_.data() + block.value + std::int64_t{c} * block.rows;
      const double factor = x[block.first + c] = unless_negligible(x[block.first + c]);
      if (factor == 0.0) continue;
      for (auto r = c + 1; r < own; ++r) x[block.first + r] -= factor * column[r];
      for (auto r = own; r < block.rows; ++r) x[rows[r - own]] -= factor * column[r];
    }
  }
}

void SymmetricFactor::backward(double* x) const {
  for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block) {
    const std::int32_t own = block->columns();
    const std::int32_t* rows = below_.data() + block->below;
    for (auto c = own; c-- > 0;) {
      const double* column = value_.data() + block->value + std::int64_t{c} * block->rows;
      double sum = x[block->first + c];
      for (auto r = c + 1; r < own; ++r) sum -= column[r] * x[block->first + r];
      for (auto r = own; r < block->rows; ++r) sum -= column[r] * x[rows[r - own]];
      x[block->first + c] = unless_negligible(sum);
    }
  }
}

Eigen::MatrixXd SymmetricFactor::solve(const Eigen::Ref<const Eigen::MatrixXd>& rhs) const {
  Eigen::MatrixXd solution(rhs.rows(), rhs.cols());
  std::vector<double> work(place_.size());
  for (Eigen::Index column = 0; column < rhs.cols(); ++column)
    solve(rhs.col(column).data(), solution.col(column).data(), work);
  return solution;
}

void SymmetricFactor::solve(const double* rhs, double* solution) {
  solve(rhs, solution, benches_.front().row);
}

void SymmetricFactor::solve(const double* rhs, double* solution, std::vector<double>& x) const {
  for (std::size_t i = 0; i < place_.size(); ++i) x[at(place_[i])] = rhs[i];
  forward(x.data());
  for (std::size_t k = 0; k < place_.size(); ++k) x[k] *= 1.0 / pivot_[k];
  backward(x.data());
  for (std::size_t i = 0; i < place_.size(); ++i) solution[i] = x[at(place_[i])];
}

std::size_t SymmetricFactor::bytes() const {
  return (value_.size() + pivot_.size() + benches_.size() * place_.size()) * sizeof(double) +
         pieces_.size() * sizeof(Piece) + piece_start_.size() * sizeof(std::int64_t) +
         (below_.size() + block_of_.size() + entry_column_.size() + entry_value_.size() +
          entry_start_.size() + 5 * place_.size()) *
             sizeof(std::int32_t);
}

}  // namespace hfrac
