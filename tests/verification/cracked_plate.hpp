// SPDX-License-Identifier: BSD-3-Clause
// A straight crack without friction in a square elastic plate under stress along x, for V22: what a formula for rock without end leaves out.
//
// Source   Crouch and Starfield (1983), Boundary Element Methods in Solid Mechanics, chapter 5: constant displacement
//          discontinuities along the crack and round the plate. Along the crack no shear is borne and the faces stay closed; round
//          the plate tractions are the load's. With n elements along the crack the slip is 0.2 % of the ellipse too high at n = 80.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

namespace verification {

struct PlateSlip {
  std::vector<double> at, slip;  // m along the crack from its middle; slip times modulus over stress, m
};

// Crack of half length c under `angle` to x, its middle `off` beside the plate's along its normal.
inline PlateSlip plate_slip(double side, double c, double angle, double off, int along_crack = 80,
                            int along_edge = 60) {
  constexpr double nu = 0.2;  // of a modulus E / (1 - nu^2) = 1; tractions given: nu does not matter
  struct Element {
    double x, y, cosine, sine, half;
  };
  std::vector<Element> elements;
  const auto line = [&](double x, double y, double way, double length, int count) {
    for (int k = 0; k < count; ++k) {
      const double s = ((k + 0.5) / count - 0.5) * length;
      elements.push_back(
          {x + s * std::cos(way), y + s * std::sin(way), std::cos(way), std::sin(way), 0.5 * length / count});
    }
  };
  line(-off * std::sin(angle), off * std::cos(angle), angle, 2.0 * c, along_crack);
  for (int edge = 0; edge < 4; ++edge) {
    const double way = 0.5 * std::numbers::pi * edge;
    line(0.5 * side * std::sin(way), -0.5 * side * std::cos(way), way, side, along_edge);
  }
  const auto n = static_cast<Eigen::Index>(elements.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * n);
  const double twice_shear = 1.0 - nu,
               share = twice_shear / (4.0 * std::numbers::pi * (1.0 - nu));  // 2 G = E / (1 + nu)
  for (Eigen::Index i = 0; i < n; ++i) {
    const Element& at = elements[static_cast<std::size_t>(i)];
    const double c2 = at.cosine * at.cosine, s2 = at.sine * at.sine, cs = at.cosine * at.sine;
    const bool crack = i < along_crack;
    for (Eigen::Index j = 0; j < n; ++j) {
      const Element& by = elements[static_cast<std::size_t>(j)];
      const double dx = at.x - by.x, dy = at.y - by.y;
      const double x = dx * by.cosine + dy * by.sine, y = dy * by.cosine - dx * by.sine, l = x - by.half,
                   r = x + by.half;
      const double l2 = l * l + y * y, r2 = r * r + y * y;
      const double fxy = share * (y / l2 - y / r2), fyy = -share * (l / l2 - r / r2),
                   fxyy = share * ((l * l - y * y) / (l2 * l2) - (r * r - y * y) / (r2 * r2)),
                   fyyy = 2.0 * y * share * (l / (l2 * l2) - r / (r2 * r2));
      const double local[2][3] = {{2.0 * fxy + y * fxyy, -y * fxyy, fyy + y * fyyy},  // xx, yy, xy by D_x
                                  {fyy + y * fyyy, fyy - y * fyyy, -y * fxyy}};       // by D_y
      for (int way = 0; way < 2; ++way) {
        const double* s = local[way];
        const double bc = by.cosine, bs = by.sine;
        const double xx = s[0] * bc * bc - 2.0 * s[2] * bc * bs + s[1] * bs * bs,
                     yy = s[0] * bs * bs + 2.0 * s[2] * bc * bs + s[1] * bc * bc,
                     xy = (s[0] - s[1]) * bc * bs + s[2] * (bc * bc - bs * bs);
        a(2 * i, 2 * j + way) = (yy - xx) * cs + xy * (c2 - s2);
        a(2 * i + 1, 2 * j + way) = xx * s2 - 2.0 * xy * cs + yy * c2;
      }
    }
    if (crack) {  // no opening
      a.row(2 * i + 1).setZero();
      a(2 * i + 1, 2 * i + 1) = 1.0;
    } else {  // one Pa along x
      right[2 * i] = -cs;
      right[2 * i + 1] = s2;
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
