// SPDX-License-Identifier: BSD-3-Clause
// Pairs of discs that may touch, for a relaxation (relaxation.hpp), until some disc has moved half the skin.
//
// A flat list for each block of discs, first < second, in ascending order of the first, which is the block's: a loop over each disc's own few
// would end at a number of turns no processor foresees. Workers take blocks. A disc gets what pairs push it with in the order of all lists.
// So what a pair pushes a second disc of another block with, always a later one, comes ahead of that block's own pairs: such pairs leave one
// block and arrive at the other; in their own block's turn that push goes nowhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/array.hpp"
#include "core/workers.hpp"
#include "geom/cell_grid.hpp"

namespace hfrac {

struct RelaxationBox {
  double width, height;   // m
  bool periodic = false;  // opposite sides joined; at least four largest radii wide and high then

  // From a place to (the nearest image of) another.
  template <bool joined>
  [[nodiscard]] Vec2 between(double x, double y, double to_x, double to_y) const {
    const Vec2 d{to_x - x, to_y - y};
    return joined ? Vec2{nearest(d.x, width), nearest(d.y, height)} : d;
  }

 private:
  // A step of at most one box does.
  [[nodiscard]] static double nearest(double distance, double side) {
    if (distance > 0.5 * side) return distance - side;
    return distance < -0.5 * side ? distance + side : distance;
  }
};

class NeighbourPairs {
 public:
  struct Arrival {
    std::size_t block, leaving;  // where it comes from, and its place there
  };
  struct Block {
    std::size_t first_disc, last_disc;
    std::vector<std::int32_t> first, second;
    std::vector<std::int32_t> receiver;  // of several blocks: the second disc, or of a leaving pair nowhere()
    std::vector<std::size_t> leaving;    // pairs whose second disc is another block's
    std::vector<Vec2> push;              // of leaving pairs: work space of the relaxation
    std::vector<Arrival> arriving;
    std::vector<std::int32_t> at_walls;  // discs that may touch a wall; of a box with walls
  };

  // block_size 0: all discs are one block.
  NeighbourPairs(const RelaxationBox& box, const Array<double>& radius, double skin, std::size_t block_size);

  // Whether one of discs first up to last moved too far for the lists.
  [[nodiscard]] bool are_due(const Array<double>& x, const Array<double>& y, std::size_t first,
                             std::size_t last) const;
  // Finds them anew. Places in a periodic box are wrapped into it.
  void find(Array<double>& x, Array<double>& y, Workers& workers);

  std::vector<Block> blocks;
  // A place beyond all discs, on a cache line of its own, which only the block's worker writes to.
  [[nodiscard]] std::size_t nowhere(std::size_t block) const {
    constexpr std::size_t line = 64 / sizeof(double);
    return ((radius_.size() + line - 1) / line + block) * line;
  }

 private:
  void wrap(Array<double>& x, Array<double>& y) const;
  void fill(std::size_t number, const CellGrid& grid, double largest);
  [[nodiscard]] bool near_side(double x, double y, double reach) const {
    return x < reach || x > box_.width - reach || y < reach || y > box_.height - reach;
  }
  template <class Take>
  void take_images(const CellGrid& grid, double x, double y, double reach, Take&& take) const;

  const RelaxationBox& box_;
  const Array<double>& radius_;
  double skin_;
  std::size_t block_size_;
  Array<double> x_, y_;  // when they were found
};

}  // namespace hfrac
