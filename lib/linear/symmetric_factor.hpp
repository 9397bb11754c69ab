// SPDX-License-Identifier: BSD-3-Clause
// L D L^T of a sparse symmetric matrix, row by row (Davis 2005, ACM Trans. Math. Softw. 31, 587-591), columns ordered by minimum degree.
//
// Row k of L solves a triangular system with the rows before it. Columns that have the same rows below them (a supernode) stand side by side
// as one dense block, and what a block does to a row is done by the dense kernels (dense_kernels.hpp): each entry's sum is made in
// the order in which the plain algorithm makes it, so the bits are those of Eigen's SimplicialLDLT, in half of its time (docs/performance.md).
// Workers make the rows of whole subtrees each (subtrees.hpp); the bits stay.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "linear/dense_kernels.hpp"
#include "linear/sparse.hpp"
#include "linear/subtrees.hpp"

namespace hfrac {

class Workers;

class SymmetricFactor {
 public:
  SymmetricFactor() = default;
  explicit SymmetricFactor(const SparseMatrix& lower) {
    analyse(lower);
    (void)factorise(lower);
  }

  // Of the lower triangle, diagonal included; what stands above it is not looked at. Its pattern, once; then its numbers, by workers if
  // there are any, which leave a zero on D's diagonal if this returns false.
  void analyse(const SparseMatrix& lower);
  bool factorise(const SparseMatrix& lower, Workers* workers = nullptr);
  [[nodiscard]] bool succeeded() const { return succeeded_; }
  // Column by column of the right-hand side.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& rhs) const;
  // The same of one column, without asking for memory.
  void solve(const double* rhs, double* solution);
  // What the factor holds.
  [[nodiscard]] std::size_t bytes() const;

 private:
  // Columns first up to last of L, by columns `rows` apart: unit lower triangle, then the rows below.
  struct Block {
    std::int32_t first, last;  // last: one past
    std::int32_t rows;         // of the block, its own columns' included
    std::int32_t filled;       // of its rows below, those that are known
    std::int64_t value;        // where it begins
    std::int64_t below;        // where its rows below do
    [[nodiscard]] std::int32_t columns() const { return last - first; }
  };
  // Columns [first, last) of a block whose values a row of L needs, one piece after the other.
  struct Piece {
    std::int32_t first, last;
  };
  void order(const SparseMatrix& lower);
  void find_blocks(const std::vector<std::int32_t>& parent, const std::vector<std::int32_t>& count);
  void find_pieces(const std::vector<std::int32_t>& parent);
  // What a row is made in.
  struct Bench {
    std::vector<double> row, gathered;
  };
  bool make_row(std::int32_t row, const double* given, Bench& bench);
  double take_piece(const Piece& piece, std::int32_t row, double pivot, Bench& bench);
  void solve(const double* rhs, double* solution, std::vector<double>& work) const;
  void forward(double* x) const;
  void backward(double* x) const;

  bool succeeded_ = false;
  std::vector<std::int32_t> place_;  // of a row of the matrix in the order of the factor
  // Of row k of the matrix in that order, entries up to the diagonal: from entry_start_[k] on, their columns and where their values are given.
  std::vector<std::int32_t> entry_start_, entry_column_, entry_value_;
  std::vector<Block> blocks_;
  std::vector<std::int32_t> block_of_;  // by column
  std::vector<std::int32_t> below_;     // rows below, block by block, ascending
  std::vector<std::int64_t> piece_start_;
  std::vector<Piece> pieces_;
  std::vector<double> value_, pivot_;
  const DenseKernels<double>& kernels_ = dense_kernels().double_precision;
  // Work space.
  std::vector<Bench> benches_{1};  // by worker
  std::vector<std::int32_t> no_swaps_;
  Subtrees subtrees_;
};

}  // namespace hfrac
