// SPDX-License-Identifier: BSD-3-Clause
#include "linear/subtrees.hpp"

#include <algorithm>
#include <numeric>

namespace hfrac {
namespace {

// Of all work, at most in a subtree, and at least in what workers take at a time.
constexpr double most_of_all = 1.0 / 24.0, least_of_all = 1.0 / 96.0;

}  // namespace

void Subtrees::cut(const std::vector<std::int32_t>& parent, const std::vector<double>& work) {
  const auto n = parent.size();
  work_ = std::accumulate(work.begin(), work.end(), 0.0);
  std::vector<double> beneath = work;  // with the row's own
  std::vector<char> waits(n, 0);       // for some row
  for (std::size_t k = 0; k < n; ++k) {
    if (parent[k] < 0) continue;
    beneath[static_cast<std::size_t>(parent[k])] += beneath[k];
    waits[static_cast<std::size_t>(parent[k])] = 1;
  }
  // The row each subtree ends with; none: above them.
  std::vector<std::int32_t> root(n, -1);
  for (auto k = n; k-- > 0;) {
    const auto above = static_cast<std::size_t>(parent[k]);
    if (parent[k] >= 0 && root[above] >= 0)
      root[k] = root[above];
    else if (beneath[k] <= most_of_all * work_ || waits[k] == 0)
      root[k] = static_cast<std::int32_t>(k);
  }
  std::vector<double> of_bundle;
  std::vector<std::int32_t> bundle(n, -1);  // of a root
  std::int32_t open = -1;                   // that small ones go to
  for (std::size_t k = 0; k < n; ++k) {
    if (root[k] != static_cast<std::int32_t>(k)) continue;
    const bool small = beneath[k] < least_of_all * work_;
    if (!small || open < 0) {
      of_bundle.push_back(0.0);
      bundle[k] = static_cast<std::int32_t>(of_bundle.size()) - 1;
      if (small) open = bundle[k];
    } else {
      bundle[k] = open;
    }
    auto& sum = of_bundle[static_cast<std::size_t>(bundle[k])];
    sum += beneath[k];
    if (small && sum >= least_of_all * work_) open = -1;
  }
  const auto bundles = of_bundle.size();
  std::vector<std::size_t> order(bundles), place(bundles);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return of_bundle[a] > of_bundle[b]; });
  for (std::size_t k = 0; k < bundles; ++k) place[order[k]] = k;
  const auto place_of = [&](std::size_t row) {
    return place[static_cast<std::size_t>(bundle[static_cast<std::size_t>(root[row])])];
  };
  start_.assign(bundles + 1, 0);
  above_.assign(n, -1);
  all_.assign(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    if (root[k] >= 0) ++start_[place_of(k) + 1];
    if (parent[k] < 0 || root[static_cast<std::size_t>(parent[k])] >= 0) continue;
    above_[k] = parent[k];
    ++all_[static_cast<std::size_t>(parent[k])];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  rows_.resize(static_cast<std::size_t>(start_.back()));
  auto next = start_;
  for (std::size_t k = 0; k < n; ++k)
    if (root[k] >= 0) rows_[static_cast<std::size_t>(next[place_of(k)]++)] = static_cast<std::int32_t>(k);
}

void Subtrees::begin() {
  waits_ = all_;
  next_ = 0;
}

}  // namespace hfrac
