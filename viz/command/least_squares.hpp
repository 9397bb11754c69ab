// SPDX-License-Identifier: BSD-3-Clause
// Straight lines through rows of a record, any stretch of them in constant time: sums up to each row, taken from each other.
#pragma once

#include <cstddef>
#include <vector>

namespace hfrac::command {

/** A line through some rows. */
struct FittedLine {
  double at_zero = 0.0, slope = 0.0;
  double error = 0.0;    ///< standard deviation of the slope
  double squares = 0.0;  ///< of what is left, summed up
};

class RowSums {
 public:
  RowSums(const std::vector<double>& x, const std::vector<double>& y);
  /** Through rows first to end - 1; two at least, of different x. */
  FittedLine line(std::size_t first, std::size_t end) const;

 private:
  struct Sums {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  };
  std::vector<Sums> sums_;
  double x0_ = 0.0, y0_ = 0.0;  // taken off, so that little is lost
};

/** Where two straight lines that meet there fit rows first to end - 1 with the least squared error, searched between `lowest` and
 * `highest`. */
struct Bend {
  double x = 0.0, y = 0.0, before = 0.0, after = 0.0;  ///< slopes
};
Bend find_bend(const std::vector<double>& x, const std::vector<double>& y, std::size_t first, std::size_t end,
               double lowest, double highest);

}  // namespace hfrac::command
