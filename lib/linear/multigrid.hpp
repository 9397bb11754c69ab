// SPDX-License-Identifier: BSD-3-Clause
// Aggregation multigrid for symmetric matrices whose entries off the diagonal are not positive (flow, heat): one cycle is the
// preconditioner of ConjugateGradient.
//
// Rows that are joined most strongly are merged, two and two, and once more two and two (Notay 2010, Electron. Trans. Numer. Anal. 37,
// 123-146); the equations of merged rows, added up, are those of a matrix a fifth as large. So on until few rows are left, which are
// factorised. An open crack, whose pipes conduct 1e10 times as well as the rock's, is merged first and so is one unknown after a
// few levels; rows that hardly depend on others (large storage, short steps) are not merged at all. Where nearly all are of that kind, as with
// cracks in tight rock and steps of milliseconds, what is left, the cracks, is the next level as it is, unmerged, and solved for exactly.
// Levels of many rows are visited twice in a cycle (W), so that iterations hardly grow with the model; those of few rows once, by one worker.
//
// Each level is smoothed by Gauss-Seidel, forward before and backward after the coarser one, within groups of fixed length; of other
// groups the values from before are taken. So that this converges whatever the groups are, a row's diagonal counts more by half of
// what it has in other groups (the l1 smoothers of Baker, Falgout, Kolev and Yang 2011, SIAM J. Sci. Comput. 33, 2864-2887, take all
// of it): M + M^T - A is then no less than the diagonal, which is all that is needed. Within a group rows go by colours: a row gets
// the first colour that none of its neighbours before it has, and rows of one colour, which do not depend on each other, stand in a row.
// So a worker sweeps along memory and a card does a colour at once (multigrid_kernels.hpp). Ranks and their workers share groups and rows, and
// no sum depends on who makes it: the same bits on any number of them, and on a card. Every rank has the whole matrix and makes all levels of
// it; those of many groups are visited by all together, the others by each for itself.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "core/rank_team.hpp"
#include "linear/aggregation.hpp"
#include "linear/multigrid_arrays.hpp"
#include "linear/sparse.hpp"
#include "linear/symmetric_factor.hpp"

namespace hfrac {

constexpr std::int64_t rows_worth_sharing = 8 * row_group;  // among workers

// How far from right a solution is at most. With s_i = a_ii - sum_j |a_ij| > 0 in every row no value is off by more than max |r_i| / s_i
// (Varah 1975, Linear Algebra Appl. 11, 3-5), and no |r_i| is larger than the residual's length in units of the diagonal's roots times
// the root of a_ii. So says storage where it rules, as in short steps; where conductances are much larger it says little.
struct ErrorBound {
  double of_length = 0.0,
         of_rounding = 0.0;  // max of root(a_ii) / s_i and a_ii / s_i; infinite: there is none

  void take(double diagonal, double others);
  void take(const ErrorBound& rows) {
    of_length = std::max(of_length, rows.of_length);
    of_rounding = std::max(of_rounding, rows.of_rounding);
  }
  // Of a residual of this length, known to as many digits as a product with values up to `largest`.
  [[nodiscard]] double at(double length, double largest) const;
  // Length of the residual at which that is no more than `error`.
  [[nodiscard]] double length_for(double error) const { return error / of_length; }
};

class Multigrid {
 public:
  // Workers, if any, share what goes row by row.
  explicit Multigrid(const Ranks& ranks = {}, Workers* workers = nullptr)
      : ranks_(ranks), workers_(workers) {}

  // A matrix and what the next coarser one is made of. Rows stand by groups and, within a group, by colours.
  struct Level {
    std::vector<std::int32_t> order,
        place;  // the row of the matrix given that stands here, and where a row of it stands
    std::vector<std::int32_t> start, upper, outer, column, group_colour,
        colour_start;                // as LevelArrays has them
    std::vector<std::int32_t> from;  // of entries: where their values are in the matrix given
    std::vector<double> value, diagonal, weight;
    std::vector<std::int32_t> aggregate;
    RowsByPart members;
    std::vector<double> inverse;
    std::vector<double> before, right, after, rest, more;  // where the cycle needs them
    double share = 1.0;                                    // as LevelArrays has it
    // Of a last level as it is; none: it is smoothed, or there is an inverse.
    std::unique_ptr<SymmetricFactor> factor;
    std::int64_t pattern = 0;  // another number for every pattern that came to any level

    [[nodiscard]] std::int64_t rows() const { return static_cast<std::int64_t>(diagonal.size()); }
    // Whether rows stand where those of the pattern that came last did; from `first` to `last` - 1 of this level's, if there are as many.
    [[nodiscard]] bool is_as_large(const SymmetricRows& rows) const {
      return order.size() == rows.diagonal.size() && from.size() == rows.column.size();
    }
    [[nodiscard]] bool fits(const SymmetricRows& rows, std::int64_t first, std::int64_t last) const;
    void take_pattern(const SymmetricRows& rows);
    void make_room(bool finest);
    ErrorBound take_values(const SymmetricRows& rows, std::int64_t first, std::int64_t last);
    [[nodiscard]] bool factorise();
    [[nodiscard]] LevelArrays arrays();
  };

  // False if an entry of the diagonal is not positive or not finite. Quicker where the pattern is that of the matrix before.
  [[nodiscard]] bool prepare(const SparseMatrix& lower);
  // The same; kept: whoever calls knows that the pattern is that of the call before, if there was one.
  enum class Pattern { any, kept };
  [[nodiscard]] bool prepare(const SymmetricRows& rows, Pattern pattern);
  [[nodiscard]] std::int64_t rows() const { return levels_[0].rows(); }
  [[nodiscard]] std::int64_t groups() const { return (rows() + row_group - 1) / row_group; }
  // Levels in use, the finest first.
  [[nodiscard]] std::span<const LevelArrays> arrays() const { return arrays_; }
  [[nodiscard]] const Level& level(std::size_t at) const { return levels_[at]; }
  // Of the matrix given.
  [[nodiscard]] const ErrorBound& error_bound() const { return error_bound_; }

  // Whether ranks share a level, and what of its rows they tell each other then; null: each has all of it.
  [[nodiscard]] bool is_over_ranks(std::size_t level = 0) const { return level < halos_.size(); }
  [[nodiscard]] Halo* halo(std::size_t level = 0) { return is_over_ranks(level) ? &halos_[level] : nullptr; }

  // z = M^-1 r, both in the order of the finest level's rows; by all members of a team together, who meet at a barrier before they read
  // what others made. Over ranks each has its own groups of both.
  void precondition(const RankTeam::Member& member, const double* r, double* z) { cycle(member, 0, r, z); }

  // Calls visit(group) for each group of a member.
  template <class Visit>
  static void each_group(const RankTeam::Member& member, std::int64_t rows, const Visit& visit) {
    const auto mine = member.part((rows + row_group - 1) / row_group, 1);
    for (auto group = mine.first; group < mine.last; ++group) visit(group);
  }

 private:
  template <class Task>
  void share_rows(std::int64_t rows, const Task& task);
  [[nodiscard]] bool fits(const Level& level, const SymmetricRows& rows);
  void cycle(const RankTeam::Member& member, std::size_t level, const double* r, double* z);
  void invert_coarsest();
  // Of rows of a level, that ranks get multiples of.
  [[nodiscard]] static std::int64_t grain(bool over_ranks) { return over_ranks ? row_group : row_group / 4; }
  void share_out();
  [[nodiscard]] Halo find_halo(std::size_t level, bool coarser_is_shared) const;

  Ranks ranks_;
  Workers* workers_;
  std::vector<Halo> halos_;  // of the levels that ranks share

  ErrorBound error_bound_;
  std::deque<Level> levels_;
  std::int64_t patterns_ = 0;        // so far
  std::vector<LevelArrays> arrays_;  // of those in use
  SymmetricRows rows_, merged_;
  std::vector<std::int32_t> pair_, pair_of_pairs_, place_;
};

}  // namespace hfrac
