// SPDX-License-Identifier: BSD-3-Clause
// The rectangle around places, as they are met.
#pragma once

#include <algorithm>
#include <cmath>

#include "snapshot.h"

namespace hfrac::viz {

struct Bounds {
  double left = INFINITY;  // [m]
  double right = -INFINITY;
  double bottom = INFINITY;
  double top = -INFINITY;

  // A circle; a place is one of radius 0.
  void include(Point centre, double radius = 0) {
    left = std::min(left, centre.x - radius);
    right = std::max(right, centre.x + radius);
    bottom = std::min(bottom, centre.y - radius);
    top = std::max(top, centre.y + radius);
  }
  bool empty() const { return !(right >= left); }
  double width() const { return right - left; }
  double height() const { return top - bottom; }
  Point middle() const { return {(left + right) / 2, (bottom + top) / 2}; }
};

}  // namespace hfrac::viz
