// SPDX-License-Identifier: BSD-3-Clause
// A straight crack without friction in a square elastic plate under stress along x, for V22: what a formula for rock without end leaves out.
//
// Source   Crouch and Starfield (1983): displacement discontinuities (displacement_discontinuity.hpp)
//          along the crack and round the plate. Along the crack no shear is borne and the faces stay closed; round
//          the plate tractions are the load's. With n elements along the crack the slip is 0.2 % of the ellipse too high at n = 80.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "displacement_discontinuity.hpp"

namespace verification {

struct PlateSlip {
  std::vector<double> at, slip;  // m along the crack from its middle; slip times modulus over stress, m
};

// Crack of half length c under `angle` to x, its middle `off` beside the plate's along its normal.
inline PlateSlip plate_slip(double side, double c, double angle, double off, int along_crack = 80,
                            int along_edge = 60) {
  std::vector<JumpElement> elements;
  add_elements(elements, -off * std::sin(angle), off * std::cos(angle), angle, 2.0 * c, along_crack);
  for (int edge = 0; edge < 4; ++edge) {
    const double way = 0.5 * std::numbers::pi * edge;
    add_elements(elements, 0.5 * side * std::sin(way), -0.5 * side * std::cos(way), way, side, along_edge);
  }
  const auto n = static_cast<Eigen::Index>(elements.size());
  Eigen::MatrixXd a = influences(elements);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (i < along_crack) {  // no opening
      a.row(2 * i + 1).setZero();
      a(2 * i + 1, 2 * i + 1) = 1.0;
    } else {  // one Pa along x
      const JumpElement& at = elements[static_cast<std::size_t>(i)];
      right[2 * i] = -at.cosine * at.sine;
      right[2 * i + 1] = at.sine * at.sine;
    }
  }
  // The plate may move as a whole: the smallest solution.
  const Eigen::VectorXd found = a.completeOrthogonalDecomposition().solve(right);
  PlateSlip result;
  for (int k = 0; k < along_crack; ++k) {
    result.at.push_back(((k + 0.5) / along_crack - 0.5) * 2.0 * c);
    result.slip.push_back(std::abs(found[2 * k]));
  }
  return result;
}

}  // namespace verification
