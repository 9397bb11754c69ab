// SPDX-License-Identifier: BSD-3-Clause
// Aggregation multigrid for symmetric matrices whose entries off the diagonal are not positive (flow, heat): one cycle is the
// preconditioner of ConjugateGradient.
//
// Rows that are joined most strongly are merged, two and two, and once more two and two (Notay 2010, Electron. Trans. Numer. Anal. 37,
// 123-146); the equations of merged rows, added up, are those of a matrix a fifth as large. So on until few rows are left, which are
// factorised. An open crack, whose pipes conduct 1e10 times as well as the rock's, is merged first and so is one unknown after a
// few levels; rows that hardly depend on others (large storage, short steps) are not merged at all. Levels of many rows are
// visited twice in a cycle (W), so that iterations hardly grow with the model; those of few rows once, by one worker.
//
// Each level is smoothed by Gauss-Seidel, forward before and backward after the coarser one, within groups of fixed length; of other
// groups the values from before are taken. So that this converges whatever the groups are, a row's diagonal counts more by half of
// what it has in other groups (the l1 smoothers of Baker, Falgout, Kolev and Yang 2011, SIAM J. Sci. Comput. 33, 2864-2887, take all
// of it): M + M^T - A is then no less than the diagonal, which is all that is needed. Workers share groups and rows, and no sum
// depends on who makes it: the same bits on any number of them.
#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "core/workers.hpp"
#include "linear/sparse.hpp"

namespace hfrac {

// Both triangles by rows, without the diagonal.
struct SymmetricRows {
  std::vector<std::int32_t> start, column;
  std::vector<double> value, diagonal;
  std::vector<double> inside;  // of merged rows: the largest entry by which they were joined, positive

  [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(diagonal.size()); }
  // Of the lower triangle, each column beginning with its diagonal.
  void assign(const SparseMatrix& lower);
};

// The rows that have the same number, ascending; negative: in no part.
class RowsByPart {
 public:
  RowsByPart() = default;
  RowsByPart(const std::vector<std::int32_t>& part, std::int32_t parts);
  [[nodiscard]] std::span<const std::int32_t> of(std::int32_t part) const {
    const auto p = static_cast<std::size_t>(part);
    return std::span(row_).subspan(static_cast<std::size_t>(first_[p]),
                                   static_cast<std::size_t>(first_[p + 1] - first_[p]));
  }

 private:
  std::vector<std::int32_t> first_, row_;
};

class Multigrid {
 public:
  static constexpr std::int64_t group = 1024;  // rows

  // False if an entry of the diagonal is not positive or not finite.
  [[nodiscard]] bool prepare(const SparseMatrix& lower);
  [[nodiscard]] std::int64_t rows() const { return levels_[0].rows(); }
  [[nodiscard]] const std::vector<double>& diagonal() const { return levels_[0].diagonal; }

  // The following are called by all members of a team together, who meet at a barrier before they read what others made.
  // y = A x
  void multiply(const Workers::Member& member, const double* x, double* y) const {
    levels_[0].multiply(member, x, y);
  }
  // z = M^-1 r
  void precondition(const Workers::Member& member, const double* r, double* z) { cycle(member, 0, r, z); }

  // Calls visit(first, end) for each group of a member.
  template <class Visit>
  static void each_group(const Workers::Member& member, std::int64_t rows, const Visit& visit) {
    const auto mine = member.part(rows, group);
    for (auto first = mine.first; first < mine.last; first += group)
      visit(first, std::min(first + group, mine.last));
  }

 private:
  struct Level {
    // Entries of row i: of its group, below the diagonal from start[i], above it from upper[i]; of other groups from outer[i].
    std::vector<std::int32_t> start, upper, outer, column;
    std::vector<double> value, diagonal;
    std::vector<double> weight;           // the diagonal as the smoother takes it
    std::vector<std::int32_t> aggregate;  // of a row: row of the coarser level; -1: none
    RowsByPart members;
    std::vector<double> right, before, after, rest, more;

    [[nodiscard]] std::int64_t rows() const { return static_cast<std::int64_t>(diagonal.size()); }
    void assign(const SymmetricRows& rows);
    void multiply(const Workers::Member& team, const double* x, double* y) const;
    void smooth_from_nothing(const Workers::Member& team, const double* right);
    [[nodiscard]] double residual(std::size_t i) const;
    void smooth_back(const Workers::Member& member, const double* right, const double* coarse,
                     double* z) const;
  };
  void cycle(const Workers::Member& member, std::size_t level, const double* r, double* z);
  void correct(const Workers::Member& member, std::size_t coarse);

  std::deque<Level> levels_;
  std::size_t depth_ = 0;    // levels in use
  bool factorised_ = false;  // the last of them
  Eigen::LLT<Eigen::MatrixXd> factor_;
  SymmetricRows rows_, merged_;
  std::vector<std::int32_t> pair_, pair_of_pairs_, place_;
};

}  // namespace hfrac
