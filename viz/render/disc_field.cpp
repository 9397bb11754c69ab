// SPDX-License-Identifier: BSD-3-Clause
// Neighbours are found through square cells as wide as the search radius: each disc looks into nine of them.
#include "disc_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hfrac::viz {
namespace {

class Cells {
 public:
  Cells(const Discs& discs, double size) : size_(size) {
    double right = -INFINITY;
    double top = -INFINITY;
    for (const Disc& disc : discs.discs) {
      left_ = std::min(left_, disc.centre.x);
      bottom_ = std::min(bottom_, disc.centre.y);
      right = std::max(right, disc.centre.x);
      top = std::max(top, disc.centre.y);
    }
    constexpr double most = 4096;  // in each direction, whatever the radius
    size_ = std::max({size_, (right - left_) / most, (top - bottom_) / most});
    columns_ = 1 + static_cast<int>((right - left_) / size_);
    rows_ = 1 + static_cast<int>((top - bottom_) / size_);
    first_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
    for (const Disc& disc : discs.discs) ++first_[cell(disc.centre) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    members_.resize(discs.discs.size());
    for (std::size_t i = 0; i < discs.discs.size(); ++i) {
      members_[next[cell(discs.discs[i].centre)]++] = static_cast<std::uint32_t>(i);
    }
  }

  template <class Visit>
  void around(Point place, const Visit& visit) const {
    const int column = column_of(place);
    const int row = row_of(place);
    for (int j = std::max(0, row - 1); j <= std::min(rows_ - 1, row + 1); ++j) {
      for (int i = std::max(0, column - 1); i <= std::min(columns_ - 1, column + 1); ++i) {
        const std::size_t index = static_cast<std::size_t>(j) * columns_ + i;
        for (std::uint32_t k = first_[index]; k < first_[index + 1]; ++k) visit(members_[k]);
      }
    }
  }

 private:
  int column_of(Point place) const {
    return std::clamp(static_cast<int>((place.x - left_) / size_), 0, columns_ - 1);
  }
  int row_of(Point place) const {
    return std::clamp(static_cast<int>((place.y - bottom_) / size_), 0, rows_ - 1);
  }
  std::size_t cell(Point place) const {
    return static_cast<std::size_t>(row_of(place)) * columns_ + column_of(place);
  }

  double size_;
  double left_ = INFINITY;
  double bottom_ = INFINITY;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> members_;
};

bool visible(const Disc& disc, const Extent& extent) {
  return disc.centre.x >= extent.left && disc.centre.x <= extent.left + extent.width &&
         disc.centre.y >= extent.bottom && disc.centre.y <= extent.bottom + extent.height;
}

}  // namespace

std::vector<double> smoothed(const Discs& discs, std::span<const double> values, double radius) {
  std::vector<double> means(values.begin(), values.end());
  if (!(radius > 0) || discs.discs.empty()) return means;
  const Cells cells(discs, radius);
  for (std::size_t i = 0; i < discs.discs.size() && i < values.size(); ++i) {
    const Point centre = discs.discs[i].centre;
    double sum = 0;
    double weights = 0;
    cells.around(centre, [&](std::uint32_t other) {
      const Disc& disc = discs.discs[other];
      const double dx = disc.centre.x - centre.x;
      const double dy = disc.centre.y - centre.y;
      const double nearness = 1 - (dx * dx + dy * dy) / (radius * radius);
      if (nearness <= 0) return;
      const double weight = nearness * nearness * disc.radius * disc.radius;
      sum += weight * values[other];
      weights += weight;
    });
    if (weights > 0) means[i] = sum / weights;
  }
  return means;
}

std::pair<double, double> usual_range(const Discs& discs, std::span<const double> values,
                                      const Extent& extent, bool two_ways) {
  std::vector<double> seen;
  for (std::size_t i = 0; i < discs.discs.size() && i < values.size(); ++i) {
    if (visible(discs.discs[i], extent)) seen.push_back(two_ways ? std::fabs(values[i]) : values[i]);
  }
  if (seen.empty()) return {0.0, 0.0};
  const auto at_share = [&](double share) {
    const auto place =
        seen.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(seen.size() - 1));
    std::nth_element(seen.begin(), place, seen.end());
    return *place;
  };
  const double highest = at_share(0.99);
  const double lowest = two_ways ? -highest : at_share(0.01);
  return {lowest, highest};
}

}  // namespace hfrac::viz
