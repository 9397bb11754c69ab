// SPDX-License-Identifier: BSD-3-Clause
// A plane through values at points, by least squares: value = offset + by_x x + by_y y.
//
// What strain is here: the slopes of the displacement over a part of the model. Sums are taken from the first point, so that
// places far from the origin cost no digits.
#pragma once

namespace hfrac {

class PlaneFit {
 public:
  struct Plane {
    double offset = 0.0, by_x = 0.0, by_y = 0.0;
  };

  void add(double x, double y, double value) {
    if (n_ == 0.0) {
      x0_ = x;
      y0_ = y;
    }
    x -= x0_;
    y -= y0_;
    n_ += 1.0;
    x_ += x;
    y_ += y;
    v_ += value;
    xx_ += x * x;
    xy_ += x * y;
    yy_ += y * y;
    xv_ += x * value;
    yv_ += y * value;
  }
  // Needs three points that are not on a line.
  [[nodiscard]] Plane plane() const {
    const double xx = xx_ - x_ * x_ / n_, xy = xy_ - x_ * y_ / n_, yy = yy_ - y_ * y_ / n_;
    const double xv = xv_ - x_ * v_ / n_, yv = yv_ - y_ * v_ / n_, determinant = xx * yy - xy * xy;
    const double by_x = (xv * yy - yv * xy) / determinant, by_y = (yv * xx - xv * xy) / determinant;
    return {v_ / n_ - by_x * (x_ / n_ + x0_) - by_y * (y_ / n_ + y0_), by_x, by_y};
  }

 private:
  double x0_ = 0.0, y0_ = 0.0, n_ = 0.0, x_ = 0.0, y_ = 0.0, v_ = 0.0;
  double xx_ = 0.0, xy_ = 0.0, yy_ = 0.0, xv_ = 0.0, yv_ = 0.0;
};

}  // namespace hfrac
