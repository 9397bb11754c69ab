// SPDX-License-Identifier: BSD-3-Clause
#include "solid/temporal_blocking.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

// Which tiles each part across tiles touches, and the other way round.
void link(const TilePlan& plan, const Assembly& a, const Network& n, TemporalBlocking& blocking) {
  const auto tiles = plan.tiles.size();
  blocking.part_start.push_back(0);
  blocking.tile_start.assign(tiles + 1, 0);
  std::vector<std::int32_t> touched;
  for (std::size_t part = 0; part < tiles; ++part) {
    const CrossPart& p = plan.cross_parts[part];
    touched.assign(1, static_cast<std::int32_t>(part));
    for (auto pair = p.first_pair; pair < p.last_pair; ++pair)
      touched.push_back(static_cast<std::int32_t>(
          a.second[static_cast<std::size_t>(plan.pairs[static_cast<std::size_t>(pair)].first_bond)] /
          tile_size));
    for (auto q = p.first_domain; q < p.last_domain; ++q) {
      const auto d = plan.cross_domain[static_cast<std::size_t>(q)];
      for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k)
        touched.push_back(static_cast<std::int32_t>(n.corner_disc[k] / tile_size));
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const auto tile : touched) ++blocking.tile_start[static_cast<std::size_t>(tile) + 1];
    blocking.part_tile.insert(blocking.part_tile.end(), touched.begin(), touched.end());
    blocking.part_start.push_back(static_cast<std::int32_t>(blocking.part_tile.size()));
  }
  for (std::size_t t = 0; t < tiles; ++t) blocking.tile_start[t + 1] += blocking.tile_start[t];
  blocking.tile_part.resize(blocking.part_tile.size());
  std::vector<std::int32_t> place(blocking.tile_start.begin(), blocking.tile_start.end() - 1);
  for (std::size_t part = 0; part < tiles; ++part) {
    for (auto k = blocking.part_start[part]; k < blocking.part_start[part + 1]; ++k)
      blocking.tile_part[place[blocking.part_tile[k]]++] = static_cast<std::int32_t>(part);
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
      : blocking_(blocking), tile_done_(tiles, 0), part_done_(blocking.part_start.size() - 1, 0) {}

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
      const auto part = blocking_.tile_part[k];
      if (part_done_[part] >= cycle) continue;
      for (auto q = blocking_.part_start[part]; q < blocking_.part_start[part + 1]; ++q) {
        if (tile_done_[blocking_.part_tile[q]] < cycle - 1) return false;
      }
    }
    return true;
  }

  void take(std::int32_t tile, std::int32_t cycle) {
    for (auto k = blocking_.tile_start[tile]; k < blocking_.tile_start[tile + 1]; ++k) {
      const auto part = blocking_.tile_part[k];
      if (part_done_[part] >= cycle) continue;
      part_done_[part] = cycle;
      blocking_.tasks.push_back({~part, cycle});
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
      const auto part = blocking_.tile_part[k];
      for (auto q = blocking_.part_start[part]; q < blocking_.part_start[part + 1]; ++q)
        add(blocking_.part_tile[q]);
    }
  }

  TemporalBlocking& blocking_;
  std::vector<std::int32_t> tile_done_, part_done_;  // cycles, by what stands on the list
};

}  // namespace

TemporalBlocking plan_blocking(const TilePlan& plan, const Assembly& assembly, const Network& network,
                               const BlockingShape& shape) {
  TemporalBlocking blocking;
  blocking.cycles = shape.cycles;
  link(plan, assembly, network, blocking);
  const auto order = front_order(plan, assembly, shape.width);
  blocking.tasks.reserve(static_cast<std::size_t>(shape.cycles) * 2 * plan.tiles.size());
  Planner planner(blocking, plan.tiles.size());
  for (std::size_t at = 0; at < order.size(); at += static_cast<std::size_t>(shape.front)) {
    const auto end = std::min(order.size(), at + static_cast<std::size_t>(shape.front));
    planner.advance(
        {order.begin() + static_cast<std::ptrdiff_t>(at), order.begin() + static_cast<std::ptrdiff_t>(end)});
  }
  return blocking;
}

}  // namespace hfrac
