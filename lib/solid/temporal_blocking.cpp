// SPDX-License-Identifier: BSD-3-Clause
#include "solid/temporal_blocking.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

// Which tiles each block of bonds touches, and the other way round.
void link(const TilePlan& plan, const Assembly& a, TemporalBlocking& blocking) {
  const auto tiles = plan.tiles.size();
  blocking.block_start.push_back(0);
  blocking.tile_start.assign(tiles + 1, 0);
  std::vector<std::int32_t> touched;
  for (std::int64_t block = 0; block < plan.bond_blocks; ++block) {
    const std::int64_t first = plan.first_cross_bond + block * cross_block,
                       last = std::min(first + cross_block, a.bond_count());
    touched.clear();
    for (auto e = first; e < last; ++e) {
      touched.push_back(static_cast<std::int32_t>(a.first[static_cast<std::size_t>(e)] / tile_size));
      touched.push_back(static_cast<std::int32_t>(a.second[static_cast<std::size_t>(e)] / tile_size));
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const auto tile : touched) ++blocking.tile_start[static_cast<std::size_t>(tile) + 1];
    blocking.block_tile.insert(blocking.block_tile.end(), touched.begin(), touched.end());
    blocking.block_start.push_back(static_cast<std::int32_t>(blocking.block_tile.size()));
  }
  for (std::size_t t = 0; t < tiles; ++t) blocking.tile_start[t + 1] += blocking.tile_start[t];
  blocking.tile_block.resize(blocking.block_tile.size());
  std::vector<std::int32_t> place(blocking.tile_start.begin(), blocking.tile_start.end() - 1);
  for (std::size_t block = 0; block + 1 < blocking.block_start.size(); ++block) {
    for (auto k = blocking.block_start[block]; k < blocking.block_start[block + 1]; ++k)
      blocking.tile_block[place[blocking.block_tile[k]]++] = static_cast<std::int32_t>(block);
  }
}

// Tiles in the order in which the front reaches them: up one strip, down the next.
std::vector<std::int32_t> front_order(const TilePlan& plan, const Assembly& a, std::int32_t width) {
  const auto tiles = plan.tiles.size();
  std::vector<Vec2> centre(tiles);
  for (std::size_t t = 0; t < tiles; ++t) {
    const Tile& tile = plan.tiles[t];
    for (auto i = tile.first_disc; i < tile.last_disc; ++i) centre[t] = centre[t] + Vec2{a.x[i], a.y[i]};
    centre[t] = (1.0 / static_cast<double>(tile.last_disc - tile.first_disc)) * centre[t];
  }
  const auto [left, right] = std::minmax_element(a.x.begin(), a.x.end());
  const auto [low, high] = std::minmax_element(a.y.begin(), a.y.end());
  const double across = std::sqrt((*right - *left) * (*high - *low) / static_cast<double>(tiles));
  const double strips = std::max(1.0, std::round((*right - *left) / (across * width)));
  const double strip_width = (*right - *left) / strips;
  struct Place {
    double strip, along;
    std::int32_t tile;
  };
  std::vector<Place> places(tiles);
  for (std::size_t t = 0; t < tiles; ++t) {
    const double strip = std::floor((centre[t].x - *left) / strip_width);
    const double up = std::fmod(strip, 2.0) == 0.0 ? 1.0 : -1.0;
    places[t] = {strip, up * centre[t].y, static_cast<std::int32_t>(t)};
  }
  std::sort(places.begin(), places.end(), [](const Place& p, const Place& q) {
    if (p.strip != q.strip) return p.strip < q.strip;
    return p.along != q.along ? p.along < q.along : p.tile < q.tile;
  });
  std::vector<std::int32_t> order;
  order.reserve(tiles);
  for (const auto& place : places) order.push_back(place.tile);
  return order;
}

// Puts tasks on the list as soon as what they need stands there.
class Planner {
 public:
  Planner(TemporalBlocking& blocking, std::size_t tiles)
      : blocking_(blocking), tile_done_(tiles, 0), block_done_(blocking.block_start.size() - 1, 0) {}

  // Tiles in `front` may begin: they and all behind them do what can be done now.
  void advance(std::vector<std::int32_t> front) {
    for (std::int32_t cycle = 1; cycle <= blocking_.cycles && !front.empty(); ++cycle) {
      std::vector<std::int32_t> next;
      for (const auto tile : front) {
        if (tile_done_[tile] != cycle - 1 || !ready(tile, cycle)) continue;
        take(tile, cycle);
        neighbours(tile, cycle, next);
      }
      front.swap(next);
    }
  }

 private:
  [[nodiscard]] bool ready(std::int32_t tile, std::int32_t cycle) const {
    for (auto k = blocking_.tile_start[tile]; k < blocking_.tile_start[tile + 1]; ++k) {
      const auto block = blocking_.tile_block[k];
      if (block_done_[block] >= cycle) continue;
      for (auto q = blocking_.block_start[block]; q < blocking_.block_start[block + 1]; ++q) {
        if (tile_done_[blocking_.block_tile[q]] < cycle - 1) return false;
      }
    }
    return true;
  }

  void take(std::int32_t tile, std::int32_t cycle) {
    for (auto k = blocking_.tile_start[tile]; k < blocking_.tile_start[tile + 1]; ++k) {
      const auto block = blocking_.tile_block[k];
      if (block_done_[block] >= cycle) continue;
      block_done_[block] = cycle;
      blocking_.tasks.push_back({~block, cycle});
    }
    tile_done_[tile] = cycle;
    blocking_.tasks.push_back({tile, cycle});
  }

  // Tiles that may have waited for this one to do their next cycle.
  void neighbours(std::int32_t tile, std::int32_t cycle, std::vector<std::int32_t>& found) const {
    const auto add = [&](std::int32_t other) {
      if (tile_done_[other] == cycle && std::find(found.begin(), found.end(), other) == found.end())
        found.push_back(other);
    };
    add(tile);
    for (auto k = blocking_.tile_start[tile]; k < blocking_.tile_start[tile + 1]; ++k) {
      const auto block = blocking_.tile_block[k];
      for (auto q = blocking_.block_start[block]; q < blocking_.block_start[block + 1]; ++q)
        add(blocking_.block_tile[q]);
    }
  }

  TemporalBlocking& blocking_;
  std::vector<std::int32_t> tile_done_, block_done_;  // cycles, by what stands on the list
};

}  // namespace

TemporalBlocking plan_blocking(const TilePlan& plan, const Assembly& assembly, const BlockingShape& shape) {
  TemporalBlocking blocking;
  blocking.cycles = shape.cycles;
  link(plan, assembly, blocking);
  const auto order = front_order(plan, assembly, shape.width);
  blocking.tasks.reserve(static_cast<std::size_t>(shape.cycles) *
                         (plan.tiles.size() + static_cast<std::size_t>(plan.bond_blocks)));
  Planner planner(blocking, plan.tiles.size());
  for (std::size_t at = 0; at < order.size(); at += static_cast<std::size_t>(shape.front)) {
    const auto end = std::min(order.size(), at + static_cast<std::size_t>(shape.front));
    planner.advance(
        {order.begin() + static_cast<std::ptrdiff_t>(at), order.begin() + static_cast<std::ptrdiff_t>(end)});
  }
  return blocking;
}

}  // namespace hfrac
