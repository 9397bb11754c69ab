// SPDX-License-Identifier: BSD-3-Clause
// Straight elements that the displacement jumps across, in elastic rock without end: what V22 and V33 solve their references with.
//
// Source   Crouch and Starfield (1983), Boundary Element Methods in Solid Mechanics, chapter 5: constant displacement discontinuities.
// Units    stresses over E / (1 - nu^2); tractions given, so that nu does not matter.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

namespace verification {

struct JumpElement {
  double x, y, cosine, sine, half;  // m; of its direction
};

// Adds a line of `count` elements around (x, y), in the direction `way` [rad].
inline void add_elements(std::vector<JumpElement>& to, double x, double y, double way, double length,
                         int count) {
  for (int k = 0; k < count; ++k) {
    const double s = ((k + 0.5) / count - 0.5) * length;
    to.push_back(
        {x + s * std::cos(way), y + s * std::sin(way), std::cos(way), std::sin(way), 0.5 * length / count});
  }
}

// Shear and normal stress on element i (rows 2 i, 2 i + 1) by the jumps along and across element j (columns 2 j, 2 j + 1).
inline Eigen::MatrixXd influences(const std::vector<JumpElement>& elements) {
  constexpr double nu = 0.2;
  const auto n = static_cast<Eigen::Index>(elements.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  const double twice_shear = 1.0 - nu,
               share = twice_shear / (4.0 * std::numbers::pi * (1.0 - nu));  // 2 G = E / (1 + nu)
  for (Eigen::Index i = 0; i < n; ++i) {
    const JumpElement& at = elements[static_cast<std::size_t>(i)];
    const double c2 = at.cosine * at.cosine, s2 = at.sine * at.sine, cs = at.cosine * at.sine;
    for (Eigen::Index j = 0; j < n; ++j) {
      const JumpElement& by = elements[static_cast<std::size_t>(j)];
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
  }
  return a;
}

}  // namespace verification
