// SPDX-License-Identifier: BSD-3-Clause
#include "geom/neighbour_pairs.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>

namespace hfrac {

NeighbourPairs::NeighbourPairs(const RelaxationBox& box, const Array<double>& radius, double skin,
                               std::size_t block_size)
    : box_(box),
      radius_(radius),
      skin_(skin),
      block_size_(block_size > 0 ? block_size : std::max<std::size_t>(1, radius.size())) {
  const std::size_t n = radius.size();
  blocks.resize((n + block_size_ - 1) / block_size_);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    blocks[b].first_disc = b * block_size_;
    blocks[b].last_disc = std::min(n, (b + 1) * block_size_);
  }
}

bool NeighbourPairs::are_due(const Array<double>& x, const Array<double>& y, std::size_t first,
                             std::size_t last) const {
  const double limit = 0.25 * skin_ * skin_;
  int far = 0;  // no early end, so that it runs in vectors
  for (std::size_t i = first; i < last; ++i) {
    const double dx = x[i] - x_[i], dy = y[i] - y_[i];
    far |= dx * dx + dy * dy > limit ? 1 : 0;
  }
  return far != 0;
}

void NeighbourPairs::find(Array<double>& x, Array<double>& y, Workers& workers) {
  if (box_.periodic) wrap(x, y);
  x_ = x;
  y_ = y;
  const double largest = *std::max_element(radius_.begin(), radius_.end());
  const CellGrid grid(x, y, 2.0 * largest + skin_);
  std::atomic<bool> no_memory{false};  // a worker may not throw
  workers.share(blocks.size() > 1, [&](const Workers::Member& member) {
    const auto mine = member.part(static_cast<std::int64_t>(blocks.size()), 1);
    try {
      for (auto b = mine.first; b < mine.last; ++b) fill(static_cast<std::size_t>(b), grid, largest);
    } catch (const std::bad_alloc&) {
      no_memory = true;
    }
  });
  if (no_memory) throw std::bad_alloc();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    for (std::size_t k = 0; k < block.leaving.size(); ++k)
      blocks[static_cast<std::size_t>(block.second[block.leaving[k]]) / block_size_].arriving.push_back(
          {b, k});
  }
}

void NeighbourPairs::fill(std::size_t number, const CellGrid& grid, double largest) {
  Block& block = blocks[number];
  for (auto* list : {&block.first, &block.second, &block.receiver, &block.at_walls}) list->clear();
  block.leaving.clear();
  block.arriving.clear();
  for (auto i = static_cast<std::int32_t>(block.first_disc); i < static_cast<std::int32_t>(block.last_disc);
       ++i) {
    const double x = x_[i], y = y_[i], reach_i = radius_[i] + largest + skin_;
    const auto take = [&](std::int32_t j) {
      if (j <= i) return;
      const Vec2 d =
          box_.periodic ? box_.between<true>(x, y, x_[j], y_[j]) : box_.between<false>(x, y, x_[j], y_[j]);
      const double reach = radius_[i] + radius_[j] + skin_;
      if (d.x * d.x + d.y * d.y >= reach * reach) return;
      if (static_cast<std::size_t>(j) >= block.last_disc) block.leaving.push_back(block.first.size());
      block.first.push_back(i);
      block.second.push_back(j);
    };
    if (box_.periodic && near_side(x, y, reach_i)) {
      take_images(grid, x, y, reach_i, take);
    } else {
      grid.near(x, y, reach_i, take);
    }
    if (!box_.periodic && near_side(x, y, radius_[i] + skin_)) block.at_walls.push_back(i);
  }
  if (blocks.size() == 1) return;
  block.receiver = block.second;
  for (const auto k : block.leaving) block.receiver[k] = static_cast<std::int32_t>(nowhere(number));
  block.push.resize(block.leaving.size());
}

void NeighbourPairs::wrap(Array<double>& x, Array<double>& y) const {
  for (auto& v : x) v -= box_.width * std::floor(v / box_.width);
  for (auto& v : y) v -= box_.height * std::floor(v / box_.height);
}

// Cells around the point and around its images; each partner once, in ascending order.
template <class Take>
void NeighbourPairs::take_images(const CellGrid& grid, double x, double y, double reach, Take&& take) const {
  std::vector<std::int32_t> around;
  for (const double shift_y : {-box_.height, 0.0, box_.height}) {
    if (y + shift_y < -reach || y + shift_y > box_.height + reach) continue;
    for (const double shift_x : {-box_.width, 0.0, box_.width}) {
      if (x + shift_x < -reach || x + shift_x > box_.width + reach) continue;
      grid.near(x + shift_x, y + shift_y, reach, [&around](std::int32_t j) { around.push_back(j); });
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  for (const auto j : around) take(j);
}

}  // namespace hfrac
