// SPDX-License-Identifier: BSD-3-Clause
// Points sorted into square cells, for finding neighbours in linear time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

class CellGrid {
 public:
  // `cell` is the smallest cell size; points outside the bounding box of all points do not occur.
  template <class X, class Y>
  CellGrid(const X& x, const Y& y, double cell) {
    const auto n = static_cast<std::int64_t>(x.size());
    if (n == 0) return;
    const auto [x_low, x_high] = std::minmax_element(x.begin(), x.end());
    const auto [y_low, y_high] = std::minmax_element(y.begin(), y.end());
    x0_ = *x_low;
    y0_ = *y_low;
    // Never more cells than a few per point, however small the cell asked for.
    const double spread = std::max(*x_high - x0_, *y_high - y0_);
    const double size = std::max({cell, spread / std::sqrt(4.0 * static_cast<double>(n) + 16.0), 1e-300});
    inverse_ = 1.0 / size;
    columns_ = static_cast<std::int64_t>((*x_high - x0_) * inverse_) + 1;
    rows_ = static_cast<std::int64_t>((*y_high - y0_) * inverse_) + 1;
    start_.assign(static_cast<std::size_t>(columns_ * rows_ + 1), 0);
    std::vector<std::int32_t> cell_of(static_cast<std::size_t>(n));
    for (std::int64_t i = 0; i < n; ++i) {
      const auto c = row(y[i]) * columns_ + column(x[i]);
      cell_of[i] = static_cast<std::int32_t>(c);
      ++start_[c + 1];
    }
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    items_.resize(static_cast<std::size_t>(n));
    auto cursor = start_;
    for (std::int64_t i = 0; i < n; ++i) items_[cursor[cell_of[i]]++] = static_cast<std::int32_t>(i);
  }

  // Calls visit(index) for every point in the cells that a square of half-width `reach` around (x, y) touches, in a
  // fixed order.
  template <class Visit>
  void near(double x, double y, double reach, Visit&& visit) const {
    if (items_.empty()) return;
    const auto c0 = column(x - reach), c1 = column(x + reach);
    const auto r0 = row(y - reach), r1 = row(y + reach);
    for (auto r = r0; r <= r1; ++r) {
      for (auto k = start_[r * columns_ + c0]; k < start_[r * columns_ + c1 + 1]; ++k) visit(items_[k]);
    }
  }

 private:
  [[nodiscard]] std::int64_t column(double x) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((x - x0_) * inverse_)), 0,
                                    columns_ - 1);
  }
  [[nodiscard]] std::int64_t row(double y) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((y - y0_) * inverse_)), 0,
                                    rows_ - 1);
  }

  double x0_ = 0.0, y0_ = 0.0, inverse_ = 1.0;
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::int32_t> start_, items_;
};

}  // namespace hfrac
