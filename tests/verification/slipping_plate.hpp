// SPDX-License-Identifier: BSD-3-Clause
// A joint under 45 degrees in the middle of a square elastic plate, which slips where the fluid in it leaves more shear than friction bears: what
// V23's formula, for rock without end, leaves out.
//
// Source   Crouch and Starfield (1983): displacement discontinuities (displacement_discontinuity.hpp) along the joint, closed, and round the plate,
//          whose tractions are the load's and do not change. What slips is found as that part on which the stress left is 0 and slip goes one way.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "displacement_discontinuity.hpp"

namespace verification {

class SlippingPlate {
 public:
  static constexpr int count = 320, along_edge = 40;  // elements of the joint, of an edge
  SlippingPlate(double side, double length) : length_(length) {
    std::vector<JumpElement> elements;
    add_elements(elements, 0.0, 0.0, 0.25 * std::numbers::pi, length, count);
    for (int edge = 0; edge < 4; ++edge) {
      const double way = 0.5 * std::numbers::pi * edge;
      add_elements(elements, 0.5 * side * std::sin(way), -0.5 * side * std::cos(way), way, side, along_edge);
    }
    const Eigen::MatrixXd all = influences(elements);
    constexpr Eigen::Index edges = 8 * along_edge;
    Eigen::MatrixXd of_edges(count, edges), on_edges(edges, count);
    without_end_.resize(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      for (Eigen::Index m = 0; m < count; ++m) without_end_(k, m) = all(2 * k, 2 * m);
      of_edges.row(k) = all.block(2 * k, 2 * count, 1, edges);
      on_edges.col(k) = all.block(2 * count, 2 * k, edges, 1);
    }
    // The plate may move as a whole: the smallest solution.
    const auto solver = all.bottomRightCorner(edges, edges).completeOrthogonalDecomposition();
    in_plate_ = without_end_ - of_edges * solver.solve(on_edges);
    const double sign = without_end_(0, 0) < 0.0 ? -1.0 : 1.0;
    without_end_ *= sign;
    in_plate_ *= sign;
  }
  // From the joint's middle [m].
  [[nodiscard]] double at(int k) const { return ((k + 0.5) / count - 0.5) * length_; }
  // Slip times E' [Pa m] under the shear drop at those places [Pa].
  [[nodiscard]] Eigen::VectorXd slip(const Eigen::VectorXd& drop, bool edges) const {
    const Eigen::MatrixXd& stiffness = edges ? in_plate_ : without_end_;
    std::vector<int> slips;
    for (int k = 0; k < count; ++k)
      if (drop[k] > 0.0) slips.push_back(k);
    Eigen::VectorXd found;
    for (int round = 0; round < count; ++round) {
      found = Eigen::VectorXd::Zero(count);
      const Eigen::VectorXd part = stiffness(slips, slips).partialPivLu().solve(Eigen::VectorXd(drop(slips)));
      found(slips) = part;
      const Eigen::VectorXd left = drop - stiffness * found;
      std::vector<int> next;
      for (int k = 0; k < count; ++k)
        if (found[k] > 0.0 || (found[k] == 0.0 && left[k] > 1e-9 * drop.maxCoeff())) next.push_back(k);
      if (next == slips) break;
      slips = std::move(next);
    }
    return found;
  }

 private:
  double length_;
  Eigen::MatrixXd without_end_, in_plate_;  // shear drop by slip times E' [1/m]
};

}  // namespace verification
