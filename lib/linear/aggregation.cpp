// SPDX-License-Identifier: BSD-3-Clause
#include "linear/aggregation.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

// A row this many times as large on the diagonal as elsewhere is left to the smoother (Notay 2010, eq. 4.1).
constexpr double dominant = 5.0;
// An entry below this share of the row's largest makes no pair.
constexpr double strong = 0.25;
// Nor does an entry between merged rows below this share of what joins the weaker of them: Gauss-Seidel on the finer level would hardly
// bring such two together.
constexpr double weak = 0.25;

bool is_dominant(const SymmetricRows& a, std::size_t i) {
  double others = 0.0;
  for (auto k = static_cast<std::size_t>(a.start[i]); k < static_cast<std::size_t>(a.start[i + 1]); ++k)
    others += std::abs(a.value[k]);
  return a.diagonal[i] > dominant * others;
}

}  // namespace

void mark_the_joined(const SymmetricRows& a, std::int64_t first, std::int64_t last,
                     std::vector<std::int32_t>& number) {
  for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
    number[i] = is_dominant(a, i) ? -1 : 0;
}

std::int32_t number_the_joined(std::vector<std::int32_t>& number) {
  std::int32_t count = 0;
  for (auto& of_row : number)
    if (of_row >= 0) of_row = count++;
  return count;
}

std::int32_t join_in_pairs(const SymmetricRows& a, std::vector<std::int32_t>& pair) {
  constexpr std::int32_t open = -2;
  const auto rows = static_cast<std::size_t>(a.count());
  for (auto& of_row : pair)
    if (of_row >= 0) of_row = open;
  const auto each_entry = [&](std::size_t i, const auto& visit) {
    for (auto k = static_cast<std::size_t>(a.start[i]); k < static_cast<std::size_t>(a.start[i + 1]); ++k)
      visit(static_cast<std::size_t>(a.column[k]), -a.value[k]);
  };
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

void merge_rows(const SymmetricRows& a, const std::vector<std::int32_t>& part, std::int32_t parts,
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

}  // namespace hfrac
