// SPDX-License-Identifier: BSD-3-Clause
#include "linear/multigrid.hpp"

#include <cmath>
#include <utility>

namespace hfrac {
namespace {

constexpr std::int64_t largest_coarsest = 200;  // rows that are factorised
// A row this many times as large on the diagonal as elsewhere is left to the smoother (Notay 2010, eq. 4.1).
constexpr double dominant = 5.0;
// An entry below this share of the row's largest makes no pair.
constexpr double strong = 0.25;
// Nor does an entry between merged rows below this share of what joins the weaker of them: Gauss-Seidel on the finer level would hardly
// bring such two together.
constexpr double weak = 0.25;
// A level of no more rows is visited once a cycle, by one worker.
constexpr std::int64_t few_rows = 2048;
// The coarser level's correction, times this: constants on pieces are stiffer than what they stand for (Braess 1995, Computing 55,
// 379-393, who takes 1.8 for larger pieces).
constexpr double over_correction = 1.15;

// Joins each row with the one that it is most strongly joined to among those still alone; who finds none alone joins that one's
// pair. With `leave_dominant` rows that hardly depend on others get -1. Returns how many pairs there are.
std::int32_t join_in_pairs(const SymmetricRows& a, bool leave_dominant, std::vector<std::int32_t>& pair) {
  constexpr std::int32_t open = -2;
  const auto rows = static_cast<std::size_t>(a.count());
  pair.assign(rows, open);
  const auto each_entry = [&](std::size_t i, const auto& visit) {
    for (auto k = static_cast<std::size_t>(a.start[i]); k < static_cast<std::size_t>(a.start[i + 1]); ++k)
      visit(static_cast<std::size_t>(a.column[k]), -a.value[k]);
  };
  for (std::size_t i = 0; leave_dominant && i < rows; ++i) {
    double others = 0.0;
    each_entry(i, [&](std::size_t, double joined) { others += std::abs(joined); });
    if (a.diagonal[i] > dominant * others) pair[i] = -1;
  }
  std::int32_t count = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    if (pair[i] != open) continue;
    double most = 0.0, most_alone = 0.0, most_paired = 0.0;
    std::size_t alone = i, paired = i;
    each_entry(i, [&](std::size_t j, double joined) {
      if (!a.inside.empty() && joined < weak * std::min(a.inside[i], a.inside[j])) return;
      most = std::max(most, joined);
      if (pair[j] == open && joined > most_alone) {
        most_alone = joined;
        alone = j;
      } else if (pair[j] >= 0 && joined > most_paired) {
        most_paired = joined;
        paired = j;
      }
    });
    if (paired != i && !(most_alone >= strong * most)) {
      pair[i] = pair[paired];
    } else {
      pair[i] = pair[alone] = count++;
    }
  }
  return count;
}

// The sums of the equations of rows that have the same number in `part`.
void merge(const SymmetricRows& a, const std::vector<std::int32_t>& part, std::int32_t parts,
           std::vector<std::int32_t>& place, SymmetricRows& merged) {
  const RowsByPart rows(part, parts);
  merged.start.assign(1, 0);
  merged.column.clear();
  merged.value.clear();
  merged.diagonal.clear();
  merged.inside.clear();
  place.assign(static_cast<std::size_t>(parts), -1);
  for (std::int32_t p = 0; p < parts; ++p) {
    const std::int32_t begin = merged.start.back();
    // What a row has on the diagonal beyond its other entries is added up by itself: those of a crack would leave nothing of it.
    double beyond = 0.0, inside = 0.0;
    for (const auto row : rows.of(p)) {
      const auto i = static_cast<std::size_t>(row);
      double sum = a.diagonal[i];
      for (auto k = static_cast<std::size_t>(a.start[i]); k < static_cast<std::size_t>(a.start[i + 1]); ++k) {
        sum += a.value[k];
        const std::int32_t q = part[static_cast<std::size_t>(a.column[k])];
        if (q == p) {
          inside = std::max(inside, -a.value[k]);
        } else if (q < 0) {  // its value is nothing as far as the coarser level knows
          beyond -= a.value[k];
        } else if (auto& at = place[static_cast<std::size_t>(q)]; at < begin) {
          at = static_cast<std::int32_t>(merged.column.size());
          merged.column.push_back(q);
          merged.value.push_back(a.value[k]);
        } else {
          merged.value[static_cast<std::size_t>(at)] += a.value[k];
        }
      }
      beyond += std::max(0.0, sum);
    }
    for (auto k = static_cast<std::size_t>(begin); k < merged.value.size(); ++k) beyond -= merged.value[k];
    merged.diagonal.push_back(beyond);
    merged.inside.push_back(inside);
    merged.start.push_back(static_cast<std::int32_t>(merged.column.size()));
  }
}

}  // namespace

RowsByPart::RowsByPart(const std::vector<std::int32_t>& part, std::int32_t parts)
    : first_(static_cast<std::size_t>(parts) + 1, 0) {
  for (const auto p : part)
    if (p >= 0) ++first_[static_cast<std::size_t>(p) + 1];
  for (std::size_t p = 0; p < static_cast<std::size_t>(parts); ++p) first_[p + 1] += first_[p];
  row_.resize(static_cast<std::size_t>(first_.back()));
  auto cursor = first_;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] >= 0)
      row_[static_cast<std::size_t>(cursor[static_cast<std::size_t>(part[i])]++)] =
          static_cast<std::int32_t>(i);
  }
}

void SymmetricRows::assign(const SparseMatrix& lower) {
  const auto rows = static_cast<std::size_t>(lower.cols());
  const int* begin = lower.outerIndexPtr();
  const int* row = lower.innerIndexPtr();
  const double* entry = lower.valuePtr();
  start.assign(rows + 1, 0);
  diagonal.resize(rows);
  for (std::size_t k = 0; k < rows; ++k) {
    diagonal[k] = entry[begin[k]];
    for (int e = begin[k] + 1; e < begin[k + 1]; ++e) {
      ++start[k + 1];
      ++start[static_cast<std::size_t>(row[e]) + 1];
    }
  }
  for (std::size_t k = 0; k < rows; ++k) start[k + 1] += start[k];
  column.resize(static_cast<std::size_t>(start.back()));
  value.resize(column.size());
  auto cursor = start;
  const auto put = [&](std::size_t i, std::size_t j, double a) {
    const auto at = static_cast<std::size_t>(cursor[i]++);
    column[at] = static_cast<std::int32_t>(j);
    value[at] = a;
  };
  for (std::size_t k = 0; k < rows; ++k) {
    for (int e = begin[k] + 1; e < begin[k + 1]; ++e) {
      put(k, static_cast<std::size_t>(row[e]), entry[e]);
      put(static_cast<std::size_t>(row[e]), k, entry[e]);
    }
  }
}

void Multigrid::Level::assign(const SymmetricRows& a) {
  start = a.start;
  diagonal = a.diagonal;
  column.resize(a.column.size());
  value.resize(a.value.size());
  for (auto* per_row : {&upper, &outer}) per_row->resize(diagonal.size());
  for (auto* per_row : {&weight, &right, &before, &after, &rest, &more}) per_row->resize(diagonal.size());
  aggregate.assign(diagonal.size(), -1);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(diagonal.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto first = static_cast<std::int32_t>(i / group * group),
               end = static_cast<std::int32_t>(first + group);
    auto to = static_cast<std::size_t>(start[at]);
    const auto put_if = [&](const auto& wanted) {
      for (auto k = static_cast<std::size_t>(a.start[at]); k < static_cast<std::size_t>(a.start[at + 1]);
           ++k) {
        if (!wanted(a.column[k])) continue;
        column[to] = a.column[k];
        value[to++] = a.value[k];
      }
      return static_cast<std::int32_t>(to);
    };
    upper[at] = put_if([&](std::int32_t j) { return j >= first && j < i; });
    outer[at] = put_if([&](std::int32_t j) { return j > i && j < end; });
    put_if([&](std::int32_t j) { return j < first || j >= end; });
    double elsewhere = 0.0;
    for (auto k = static_cast<std::size_t>(outer[at]); k < to; ++k) elsewhere += std::abs(value[k]);
    weight[at] = diagonal[at] + 0.5 * elsewhere;
  }
}

bool Multigrid::prepare(const SparseMatrix& lower) {
  rows_.assign(lower);
  for (const double d : rows_.diagonal)
    if (!(d > 0.0) || !std::isfinite(d)) return false;
  for (depth_ = 0;;) {
    if (levels_.size() == depth_) levels_.emplace_back();
    Level& level = levels_[depth_++];
    level.assign(rows_);
    if (rows_.count() <= largest_coarsest) break;
    merge(rows_, pair_, join_in_pairs(rows_, true, pair_), place_, merged_);
    const auto count = join_in_pairs(merged_, false, pair_of_pairs_);
    if (count == 0 || count >= level.rows()) break;
    for (std::size_t i = 0; i < pair_.size(); ++i)
      level.aggregate[i] = pair_[i] < 0 ? -1 : pair_of_pairs_[static_cast<std::size_t>(pair_[i])];
    level.members = RowsByPart(level.aggregate, count);
    merge(merged_, pair_of_pairs_, count, place_, rows_);
    rows_.inside.clear();
  }
  const Level& last = levels_[depth_ - 1];
  factorised_ = last.rows() <= largest_coarsest;
  if (factorised_) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(last.rows(), last.rows());
    for (Eigen::Index i = 0; i < last.rows(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      matrix(i, i) = last.diagonal[at];
      for (auto k = static_cast<std::size_t>(last.start[at]);
           k < static_cast<std::size_t>(last.start[at + 1]); ++k)
        matrix(i, last.column[k]) = last.value[k];
    }
    factor_.compute(matrix);
    factorised_ = factor_.info() == Eigen::Success;
  }
  return true;
}

void Multigrid::Level::multiply(const Workers::Member& team, const double* x, double* y) const {
  each_group(team, rows(), [&](std::int64_t first, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) {
      double sum = diagonal[i] * x[i];
      for (auto k = static_cast<std::size_t>(start[i]); k < static_cast<std::size_t>(start[i + 1]); ++k)
        sum += value[k] * x[column[k]];
      y[i] = sum;
    }
  });
}

// Forward, from 0.
void Multigrid::Level::smooth_from_nothing(const Workers::Member& team, const double* b) {
  each_group(team, rows(), [&](std::int64_t first, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) {
      double sum = b[i];
      for (auto k = static_cast<std::size_t>(start[i]); k < static_cast<std::size_t>(upper[i]); ++k)
        sum -= value[k] * before[static_cast<std::size_t>(column[k])];
      before[i] = sum / weight[i];
    }
  });
}

// Right-hand side less product after that: what lies below the diagonal was already taken away.
double Multigrid::Level::residual(std::size_t i) const {
  double sum = (weight[i] - diagonal[i]) * before[i];
  for (auto k = static_cast<std::size_t>(upper[i]); k < static_cast<std::size_t>(start[i + 1]); ++k)
    sum -= value[k] * before[static_cast<std::size_t>(column[k])];
  return sum;
}

// Adds the coarser level's correction (nullptr: none), then backward.
void Multigrid::Level::smooth_back(const Workers::Member& team, const double* b, const double* coarse,
                                   double* z) const {
  const auto corrected = [&](std::size_t i) {
    return coarse == nullptr || aggregate[i] < 0 ? before[i]
                                                 : before[i] + over_correction * coarse[aggregate[i]];
  };
  each_group(team, rows(), [&](std::int64_t first, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i)
      z[i] = corrected(i);
    for (auto i = static_cast<std::size_t>(end); i-- > static_cast<std::size_t>(first);) {
      double sum = b[i] - diagonal[i] * z[i];
      for (auto k = static_cast<std::size_t>(start[i]); k < static_cast<std::size_t>(outer[i]); ++k)
        sum -= value[k] * z[column[k]];
      for (auto k = static_cast<std::size_t>(outer[i]); k < static_cast<std::size_t>(start[i + 1]); ++k)
        sum -= value[k] * corrected(static_cast<std::size_t>(column[k]));
      z[i] += sum / weight[i];
    }
  });
}

void Multigrid::cycle(const Workers::Member& member, std::size_t at, const double* r, double* z) {
  Level& level = levels_[at];
  const bool last = at + 1 == depth_;
  if (last && factorised_) {
    if (member.number == 0) {
      Eigen::Map<Eigen::VectorXd> solution(z, level.rows());
      solution = Eigen::Map<const Eigen::VectorXd>(r, level.rows());
      factor_.solveInPlace(solution);
    }
    return;
  }
  level.smooth_from_nothing(member, r);
  member.barrier();
  if (last) {
    level.smooth_back(member, r, nullptr, z);
    return;
  }
  Level& coarse = levels_[at + 1];
  const auto mine = member.part(coarse.rows(), group / 4);
  for (auto g = static_cast<std::size_t>(mine.first); g < static_cast<std::size_t>(mine.last); ++g) {
    double sum = 0.0;
    for (const auto i : level.members.of(static_cast<std::int32_t>(g)))
      sum += level.residual(static_cast<std::size_t>(i));
    coarse.right[g] = sum;
  }
  member.barrier();
  if (coarse.rows() > few_rows) {
    correct(member, at + 1);
  } else if (member.number == 0) {
    cycle({member.team, 0, 1}, at + 1, coarse.right.data(), coarse.after.data());
  }
  member.barrier();
  level.smooth_back(member, r, coarse.after.data(), z);
}

// The coarser level's equations, twice.
void Multigrid::correct(const Workers::Member& member, std::size_t at) {
  Level& level = levels_[at];
  cycle(member, at, level.right.data(), level.after.data());
  member.barrier();
  level.multiply(member, level.after.data(), level.rest.data());
  const auto each_row = [&](const auto& change) {
    each_group(member, level.rows(), [&](std::int64_t first, std::int64_t end) {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) change(i);
    });
  };
  each_row([&](std::size_t i) { level.rest[i] = level.right[i] - level.rest[i]; });
  cycle(member, at, level.rest.data(), level.more.data());
  each_row([&](std::size_t i) { level.after[i] += level.more[i]; });
}

}  // namespace hfrac
