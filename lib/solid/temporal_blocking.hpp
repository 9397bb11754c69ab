// SPDX-License-Identifier: BSD-3-Clause
// In which order several cycles in a row go through memory (temporal blocking).
//
// One cycle after the other, a model that no cache holds comes from memory once in every cycle. But a tile can do cycle t as soon
// as the tiles around it have done t - 1; the rest of the model need not have. So a front sweeps over the model: where it comes,
// tiles do cycle 1, some way behind it cycle 2, and so on to the last; what lies between is in the cache still. Nothing is done
// twice, and every sum is made in the order of tiles.hpp, so results have the same bits as one cycle at a time. (The wavefront of
// Wellein, Hager, Zeiser, Wittmann and Fehske 2009; here over tiles of irregular shape, with what waits for what worked out once.)
//
// Tiles are shared out in regions, a front in each, one for each worker: a core keeps a tile from one cycle to the next, and from
// one sweep to the next what its own cache holds. The front goes up and down through strips as wide as the cache allows. What has
// to be done stands in one list, tiles and parts across tiles, each after all that it needs, whoever does that. A worker goes through
// the list and does what is of its region (blocked_batch.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"
#include "model/assembly.hpp"
#include "solid/tiles.hpp"

namespace hfrac {

struct TemporalBlocking {
  struct Task {
    std::int32_t item;   // a tile, or ~part across tiles
    std::int32_t cycle;  // 1 to `cycles`
    std::int32_t region;
  };
  std::int32_t cycles = 0, regions = 1;
  std::vector<Task> tasks;
  // Tiles that a part across tiles touches, parts that touch a tile.
  std::vector<std::int32_t> part_start, part_tile, tile_start, tile_part;

  [[nodiscard]] bool empty() const { return tasks.empty(); }
};

// Whether workers, each with its part of so many tiles, had better do several cycles in one sweep. Where the part is not many times a
// core's own cache, one cycle after the other finds tiles sooner than memory would be asked (docs/performance.md).
bool is_worth_blocking(std::int64_t tiles, int workers);

struct BlockingShape {
  std::int32_t cycles;  // in one sweep
  std::int32_t width;   // of a strip, in tiles
  std::int32_t front;   // tiles a front takes at a time
};

// 3 cycles keep some 80 tiles of a region in use, 13 MB. More find no room in a cache that others use too (docs/performance.md).
constexpr BlockingShape blocking_shape{3, 8, 4};

TemporalBlocking plan_blocking(const TilePlan& plan, const Assembly& assembly, const Network& network,
                               const BlockingShape& shape, std::int32_t regions);

}  // namespace hfrac
