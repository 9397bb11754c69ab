// SPDX-License-Identifier: BSD-3-Clause
// Snapshots of more discs or pores than a browser can draw, as averages over the squares of a raster: what lies in a square is one disc as
// large as all of them together, or the square itself, with the mean of each value by area. How many it stands for is a value of its own,
// "averaged"; numbers of discs and pores are left out.
#pragma once

#include <cstdint>
#include <memory>

#include "web/server/grid.hpp"

namespace hfrac::web {

/** Discs, bonds or pores: several for each pixel of a screen. */
constexpr int64_t kMostDrawn = 4'000'000;

/** The grid itself if it has no more than `most` points and cells; else a quarter as many squares. Lines have no average that shows
 * them: of those, GridError says what does. */
std::shared_ptr<const Grid> averaged(std::shared_ptr<const Grid> grid, int64_t most);

}  // namespace hfrac::web
