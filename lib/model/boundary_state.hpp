// SPDX-License-Identifier: BSD-3-Clause
// What holds the model from outside, as data; what it does stands in solid/boundary.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

struct Wall {
  Vec2 inward;                // unit normal into the model
  double length = 0.0;        // m
  double target = 0.0;        // Pa
  double displacement = 0.0;  // m, inward
  double velocity = 0.0;
  std::vector<std::int32_t> discs;
};

struct BoundaryState {
  std::array<Wall, 4> walls;     // left, right, lower, upper; without discs under stress control
  bool servo = true;             // walls follow the far field
  double load = 0.0;             // factor of the far field in force, 0 to 1
  double work = 0.0;             // J/m, of the walls
  double imbalance = 0.0;        // largest unbalanced force on a wall over its target
  double carried_work = 0.0;     // J/m, of far fields before this one
  std::vector<Vec2> cell_load;   // N on the discs of the outer boundary, from the stress a host set by cell
  std::size_t loaded_discs = 0;  // how many those are

  template <class Archive, class Self>
  static void visit(Archive& archive, Self& s) {
    for (auto& wall : s.walls) {
      archive.value(wall.displacement);
      archive.value(wall.velocity);
    }
    archive.value(s.servo);
    archive.value(s.load);
    archive.value(s.work);
    archive.value(s.imbalance);
    archive.value(s.carried_work);
    archive.list(s.cell_load, [](auto& ar, auto& force) {
      ar.value(force.x);
      ar.value(force.y);
    });
    archive.require(s.cell_load.size() == s.loaded_discs);
  }
};

}  // namespace hfrac
