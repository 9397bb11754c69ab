// SPDX-License-Identifier: BSD-3-Clause
#include "linear/multigrid.hpp"

#include <Eigen/Cholesky>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "core/give_back.hpp"
#include "linear/multigrid_kernels.hpp"
#include "linear/serial_block.hpp"

namespace hfrac {
namespace {

constexpr std::int64_t largest_coarsest = 200;  // rows that are factorised
// The coarser level's correction, times this: constants on pieces are stiffer than what they stand for (Braess 1995, Computing 55,
// 379-393, who takes 1.8 for larger pieces).
constexpr double over_correction = 1.15;
// Where no more than one row in so many depends on others, and no more than so many do, those are the next level as they are, and the last.
constexpr std::int64_t rows_of_one = 8, most_factorised = 20000;
// Groups of a level that a rank gets on the mean where ranks share it.
constexpr std::int64_t groups_of_a_rank = 4;

}  // namespace

void ErrorBound::take(double diagonal, double others) {
  const double sum = diagonal - others;
  // What is left of a row by rounding alone bounds nothing.
  const bool rules = sum > 1e-12 * diagonal;
  constexpr double none = std::numeric_limits<double>::infinity();
  take({rules ? std::sqrt(diagonal) / sum : none, rules ? diagonal / sum : none});
}

double ErrorBound::at(double length, double largest) const {
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  return of_length * length + of_rounding * rounding * largest;
}

bool Multigrid::Level::fits(const SymmetricRows& a, std::int64_t first, std::int64_t last) const {
  for (auto p = static_cast<std::size_t>(first); p < static_cast<std::size_t>(last); ++p) {
    const auto i = static_cast<std::size_t>(order[p]);
    if (start[p + 1] - start[p] != a.start[i + 1] - a.start[i]) return false;
    for (auto k = static_cast<std::size_t>(start[p]); k < static_cast<std::size_t>(start[p + 1]); ++k) {
      const auto at = from[k];
      if (at < a.start[i] || at >= a.start[i + 1] ||
          place[static_cast<std::size_t>(a.column[static_cast<std::size_t>(at)])] != column[k])
        return false;
    }
  }
  return true;
}

// Rows of a group by colours, and each row's entries by what the smoother knows of them.
void Multigrid::Level::take_pattern(const SymmetricRows& a) {
  const auto rows = static_cast<std::int32_t>(a.count());
  const auto rows_there = static_cast<std::size_t>(rows);
  order.resize(rows_there);
  place.resize(rows_there);
  group_colour.assign(1, 0);
  colour_start.clear();
  std::vector<std::int32_t> colour(rows_there), taken_by, count;
  for (std::int32_t first = 0; first < rows; first += row_group) {
    const auto end = std::min(rows, first + static_cast<std::int32_t>(row_group));
    count.clear();
    for (auto i = first; i < end; ++i) {
      const auto at = static_cast<std::size_t>(i);
      taken_by.resize(count.size(), -1);
      for (auto k = static_cast<std::size_t>(a.start[at]); k < static_cast<std::size_t>(a.start[at + 1]);
           ++k) {
        if (const auto j = a.column[k]; j >= first && j < i)
          taken_by[static_cast<std::size_t>(colour[static_cast<std::size_t>(j)])] = i;
      }
      const auto free = std::find_if(taken_by.begin(), taken_by.end(), [i](auto by) { return by != i; });
      const auto mine = static_cast<std::size_t>(free - taken_by.begin());
      if (mine == count.size()) count.push_back(0);
      colour[at] = static_cast<std::int32_t>(mine);
      ++count[mine];
    }
    auto next = first;
    for (auto& of_colour : count) {
      colour_start.push_back(next);
      next += std::exchange(of_colour, next);  // from here on where its next row goes
    }
    for (auto i = first; i < end; ++i) {
      const auto to = count[static_cast<std::size_t>(colour[static_cast<std::size_t>(i)])]++;
      order[static_cast<std::size_t>(to)] = i;
      place[static_cast<std::size_t>(i)] = to;
    }
    group_colour.push_back(static_cast<std::int32_t>(colour_start.size()));
    taken_by.clear();
  }
  colour_start.push_back(rows);
  start.assign(1, 0);
  upper.clear();
  outer.clear();
  column.clear();
  from.clear();
  column.reserve(a.column.size());
  from.reserve(a.column.size());
  for (std::int32_t p = 0; p < rows; ++p) {
    const auto i = static_cast<std::size_t>(order[static_cast<std::size_t>(p)]);
    const auto first = static_cast<std::int32_t>(p / row_group * row_group),
               end = static_cast<std::int32_t>(first + row_group);
    const auto put_if = [&](const auto& wanted) {
      for (auto k = a.start[i]; k < a.start[i + 1]; ++k) {
        const auto q = place[static_cast<std::size_t>(a.column[static_cast<std::size_t>(k)])];
        if (!wanted(q)) continue;
        column.push_back(q);
        from.push_back(k);
      }
      return static_cast<std::int32_t>(column.size());
    };
    upper.push_back(put_if([&](std::int32_t q) { return q >= first && q < p; }));
    outer.push_back(put_if([&](std::int32_t q) { return q > p && q < end; }));
    start.push_back(put_if([&](std::int32_t q) { return q < first || q >= end; }));
  }
}

void Multigrid::Level::make_room(bool finest) {
  const auto rows = order.size();
  value.resize(from.size());
  for (auto* per_row : {&diagonal, &weight, &before}) per_row->resize(rows);
  for (auto* per_row : {&right, &after}) per_row->resize(finest ? 0 : rows);
  const bool visited_twice = !finest && static_cast<std::int64_t>(rows) > few_rows;
  for (auto* per_row : {&rest, &more}) per_row->resize(visited_twice ? rows : 0);
  aggregate.assign(rows, -1);
  members = {};
  inverse.clear();
}

ErrorBound Multigrid::Level::take_values(const SymmetricRows& a, std::int64_t first, std::int64_t last) {
  ErrorBound bound;
  for (auto p = static_cast<std::size_t>(first); p < static_cast<std::size_t>(last); ++p) {
    diagonal[p] = a.diagonal[static_cast<std::size_t>(order[p])];
    double inside = 0.0, elsewhere = 0.0;
    for (auto k = static_cast<std::size_t>(start[p]); k < static_cast<std::size_t>(start[p + 1]); ++k) {
      value[k] = a.value[static_cast<std::size_t>(from[k])];
      (k >= static_cast<std::size_t>(outer[p]) ? elsewhere : inside) += std::abs(value[k]);
    }
    weight[p] = diagonal[p] + 0.5 * elsewhere;
    bound.take(diagonal[p], inside + elsewhere);
  }
  return bound;
}

bool Multigrid::Level::factorise() {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t p = 0; p < order.size(); ++p) {
    const auto row = static_cast<std::int32_t>(p);
    entries.emplace_back(row, row, diagonal[p]);
    for (auto k = static_cast<std::size_t>(start[p]); k < static_cast<std::size_t>(start[p + 1]); ++k)
      if (column[k] < row) entries.emplace_back(row, column[k], value[k]);
  }
  SparseMatrix lower(rows(), rows());
  lower.setFromTriplets(entries.begin(), entries.end());
  factor = std::make_unique<SymmetricFactor>(lower);
  return factor->succeeded();
}

LevelArrays Multigrid::Level::arrays() {
  LevelArrays a{};
  a.rows = rows();
  a.share = share;
  a.start = start.data();
  a.upper = upper.data();
  a.outer = outer.data();
  a.column = column.data();
  a.value = value.data();
  a.diagonal = diagonal.data();
  a.weight = weight.data();
  a.group_colour = group_colour.data();
  a.colour_start = colour_start.data();
  a.aggregate = aggregate.data();
  if (!members.first().empty()) {
    a.first = members.first().data();
    a.member = members.rows().data();
  }
  if (!inverse.empty()) a.inverse = inverse.data();
  a.right = right.data();
  a.before = before.data();
  a.after = after.data();
  a.rest = rest.data();
  a.more = more.data();
  return a;
}

// Runs task(first, last) on parts of so many rows.
template <class Task>
void Multigrid::share_rows(std::int64_t rows, const Task& task) {
  share_items(workers_, rows, task, rows_worth_sharing, row_group);
}

bool Multigrid::fits(const Level& level, const SymmetricRows& rows) {
  if (!level.is_as_large(rows)) return false;
  std::atomic<bool> all{true};
  share_rows(rows.count(), [&](std::int64_t first, std::int64_t last) {
    if (!level.fits(rows, first, last)) all = false;
  });
  return all;
}

bool Multigrid::prepare(const SparseMatrix& lower) {
  SymmetricRows rows;
  rows.assign(lower);
  return prepare(rows, Pattern::any);
}

bool Multigrid::prepare(const SymmetricRows& given, Pattern pattern) {
  std::atomic<bool> positive{true};
  share_rows(given.count(), [&](std::int64_t first, std::int64_t last) {
    const auto* diagonal = given.diagonal.data();
    if (!std::all_of(diagonal + first, diagonal + last, [](double d) { return d > 0.0 && std::isfinite(d); }))
      positive = false;
  });
  if (!positive) return false;
  std::size_t depth = 0;
  bool as_they_are = false;
  for (std::int32_t count = 0;;) {
    const bool has_pattern = levels_.size() > depth;
    if (!has_pattern) levels_.emplace_back();
    Level& level = levels_[depth];
    const SymmetricRows& rows = depth == 0 ? given : rows_;
    const bool fits_still = depth == 0 && has_pattern && (pattern == Pattern::kept || fits(level, rows));
    if (!fits_still) {
      level.take_pattern(rows);
      level.pattern = ++patterns_;
    }
    level.make_room(depth == 0);
    ErrorBound bound;
    std::mutex one_by_one;
    share_rows(rows.count(), [&](std::int64_t first, std::int64_t last) {
      const ErrorBound mine = level.take_values(rows, first, last);
      const std::lock_guard lock(one_by_one);
      bound.take(mine);
    });
    if (depth == 0) error_bound_ = bound;
    if (depth > 0) {
      give_back(level.from);  // its pattern is taken anew each time
      // The finer one's rows now know where theirs stand.
      Level& finer = levels_[depth - 1];
      for (std::size_t p = 0; p < finer.order.size(); ++p) {
        const auto pair = pair_[static_cast<std::size_t>(finer.order[p])];
        if (pair >= 0)
          finer.aggregate[p] = level.place[static_cast<std::size_t>(
              as_they_are ? pair : pair_of_pairs_[static_cast<std::size_t>(pair)])];
      }
      finer.share = as_they_are ? 1.0 : over_correction;
      finer.members = RowsByPart(finer.aggregate, count);
    }
    level.factor.reset();
    ++depth;
    if (rows.count() <= largest_coarsest) break;
    if (as_they_are) {
      if (!level.factorise()) return false;
      break;
    }
    pair_.resize(static_cast<std::size_t>(rows.count()));
    share_rows(rows.count(),
               [&](std::int64_t first, std::int64_t last) { mark_the_joined(rows, first, last, pair_); });
    count = number_the_joined(pair_);
    if (count == 0) break;
    as_they_are = level.rows() > few_rows && count <= std::min(level.rows() / rows_of_one, most_factorised);
    if (as_they_are) {
      merge_rows(rows, pair_, count, place_, merged_);
      std::swap(rows_, merged_);
      rows_.inside.clear();
      continue;
    }
    merge_rows(rows, pair_, join_in_pairs(rows, pair_), place_, merged_);
    pair_of_pairs_.assign(static_cast<std::size_t>(merged_.count()), 0);
    count = join_in_pairs(merged_, pair_of_pairs_);
    if (count == 0 || count >= level.rows()) break;
    merge_rows(merged_, pair_of_pairs_, count, place_, rows_);
    rows_.inside.clear();
  }
  levels_.resize(depth);
  if (levels_.back().rows() <= largest_coarsest) invert_coarsest();
  arrays_.clear();
  for (auto& level : levels_) arrays_.push_back(level.arrays());
  share_out();
  // Made anew for the next matrix: a solution's vectors take their place meanwhile.
  for (auto* rows : {&rows_, &merged_}) *rows = SymmetricRows();
  for (auto* list : {&pair_, &pair_of_pairs_, &place_}) give_back(*list);
  return true;
}

// A few hundred rows: their inverse is as long as two triangles, and every row of a product with it stands alone.
void Multigrid::invert_coarsest() {
  Level& last = levels_.back();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(last.rows(), last.rows());
  for (Eigen::Index i = 0; i < last.rows(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    matrix(i, i) = last.diagonal[at];
    for (auto k = static_cast<std::size_t>(last.start[at]); k < static_cast<std::size_t>(last.start[at + 1]);
         ++k)
      matrix(i, last.column[k]) += last.value[k];
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) return;
  const Eigen::MatrixXd inverse = factor.solve(Eigen::MatrixXd::Identity(last.rows(), last.rows()));
  last.inverse.resize(static_cast<std::size_t>(inverse.size()));
  Eigen::Map<Eigen::MatrixXd>(last.inverse.data(), last.rows(), last.rows()) =
      0.5 * (inverse + inverse.transpose());
}

// With few groups to a rank a level is done sooner than told of.
void Multigrid::share_out() {
  halos_.clear();
  if (ranks_.alone()) return;
  const auto is_shared = [&](std::size_t at) {
    return at < arrays_.size() && !levels_[at].factor &&
           arrays_[at].rows >= groups_of_a_rank * row_group * ranks_.size();
  };
  for (std::size_t at = 0; is_shared(at); ++at) halos_.push_back(find_halo(at, is_shared(at + 1)));
}

// Rows of the level that ranks need of each other: all that have to do with rows they own, of it, of the coarser level (take_to_coarser)
// and of the finer one (smooth_back). Both ends of a message find the same list, each from its own rows.
Halo Multigrid::find_halo(std::size_t at, bool coarser_is_shared) const {
  const int here = ranks_.rank();
  std::vector<Halo::Row> send, receive;
  const auto tell = [&](std::vector<Halo::Row>& list, std::int32_t rank, std::int64_t row) {
    if (rank != here) list.push_back({rank, static_cast<std::int32_t>(row)});
  };
  // Calls visit(j) for row i and those it is joined to.
  const auto each_of_star = [](const LevelArrays& l, std::int64_t i, const auto& visit) {
    visit(i);
    for (auto k = l.start[i]; k < l.start[i + 1]; ++k) visit(l.column[k]);
  };
  const auto owner_of_rows = [&](std::int64_t rows, std::int64_t grain) {
    const auto mine = ranks_.part(here, rows, grain);
    return [=, this](std::int64_t i) {
      return i >= mine.first && i < mine.end ? here : ranks_.owner(i, rows, grain);
    };
  };
  const LevelArrays& level = arrays_[at];
  const auto owner = owner_of_rows(level.rows, row_group);
  const auto mine = ranks_.part(here, level.rows, row_group);
  for (auto i = mine.first; i < mine.end; ++i) {
    each_of_star(level, i, [&](std::int64_t j) {
      tell(send, owner(j), i);
      tell(receive, owner(j), j);
    });
  }
  // What a finer row asks of row c of a coarser level: that those who have c know the rows around, or the other way round.
  const auto each_pair = [&](const LevelArrays& fine, const LevelArrays& coarse, std::int64_t coarse_grain,
                             const auto& of_fine, const auto& of_coarse) {
    const auto rows = ranks_.part(here, fine.rows, row_group);
    for (auto i = rows.first; i < rows.end; ++i) {
      each_of_star(fine, i, [&](std::int64_t j) {
        if (fine.aggregate[j] >= 0) of_fine(i, fine.aggregate[j]);
      });
    }
    const auto merged = ranks_.part(here, coarse.rows, coarse_grain);
    for (auto c = merged.first; c < merged.end; ++c) {
      for (auto m = fine.first[c]; m < fine.first[c + 1]; ++m)
        each_of_star(fine, fine.member[m], [&](std::int64_t j) { of_coarse(c, j); });
    }
  };
  if (at + 1 < arrays_.size()) {
    const LevelArrays& coarse = arrays_[at + 1];
    const std::int64_t coarse_grain = grain(coarser_is_shared);
    const auto coarse_owner = owner_of_rows(coarse.rows, coarse_grain);
    each_pair(
        level, coarse, coarse_grain, [&](std::int64_t i, std::int64_t c) { tell(send, coarse_owner(c), i); },
        [&](std::int64_t, std::int64_t j) { tell(receive, owner(j), j); });
  }
  if (at > 0) {
    const LevelArrays& fine = arrays_[at - 1];
    const auto fine_owner = owner_of_rows(fine.rows, row_group);
    each_pair(
        fine, level, row_group, [&](std::int64_t, std::int64_t c) { tell(receive, owner(c), c); },
        [&](std::int64_t c, std::int64_t j) { tell(send, fine_owner(j), c); });
  }
  return {std::move(send), std::move(receive)};
}

// Levels of many rows are solved for twice, which workers and ranks share; those of few by one of each rank.
void Multigrid::cycle(const RankTeam::Member& team, std::size_t at, const double* r, double* z) {
  const LevelArrays& level = arrays_[at];
  SerialBlock block;
  if (levels_[at].factor) {
    if (team.is_first()) levels_[at].factor->solve(r, z);
    return;
  }
  if (level.rows <= few_rows) {
    if (team.is_first())
      visit_few(block, arrays_.data(), static_cast<std::int64_t>(at),
                static_cast<std::int64_t>(arrays_.size()), r, z);
    return;
  }
  const auto member = team.among(is_over_ranks(at)), below = team.among(is_over_ranks(at + 1));
  const auto each = [&](const auto& visit) { each_group(member, level.rows, visit); };
  each([&](std::int64_t group) { smooth_from_nothing(block, level, r, group); });
  member.exchange(halo(at), level.before);
  const LevelArrays* coarse = at + 1 < arrays_.size() ? &arrays_[at + 1] : nullptr;
  if (coarse != nullptr) {
    const std::int64_t parts = grain(below.is_over_ranks());
    const auto mine = member.part(coarse->rows, parts, row_group / 4);
    take_to_coarser(block, level, *coarse, mine.first, mine.last);
    if (below.is_over_ranks())
      below.barrier();
    else
      member.gather(coarse->right, coarse->rows, parts);
    cycle(team, at + 1, coarse->right, coarse->after);
    below.exchange(halo(at + 1), coarse->after);
    if (coarse->rows > few_rows && !levels_[at + 1].factor) {
      const auto each_coarse = [&](const auto& visit) { each_group(below, coarse->rows, visit); };
      each_coarse([&](std::int64_t group) { find_rest_of_group(block, *coarse, group); });
      cycle(team, at + 1, coarse->rest, coarse->more);
      each_coarse([&](std::int64_t group) { add_more(block, *coarse, group); });
      below.exchange(halo(at + 1), coarse->after);
    }
  }
  each([&](std::int64_t group) {
    smooth_back(block, level, r, coarse != nullptr ? coarse->after : nullptr, z, group);
  });
}

}  // namespace hfrac
