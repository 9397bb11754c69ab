// SPDX-License-Identifier: BSD-3-Clause
// Lets overlapping discs push each other apart until their forces balance: the energy of overlaps (stiffness 1, no
// friction) is minimised with FIRE (Bitzek, Koskinen, Gähler, Moseler and Gumbsch 2006). The sides of the box are flat
// walls, or its opposite sides are one and the same (periodic). Every sum is made in one order: the same bits on any number of workers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/array.hpp"
#include "core/workers.hpp"
#include "geom/neighbour_pairs.hpp"

namespace hfrac {

struct RelaxationReport {
  double residual = 0.0;      // mean unbalanced over mean contact force, of discs that may move
  double mean_overlap = 0.0;  // mean overlap of contacts over mean radius
  std::int64_t iterations = 0;
  bool at_rest = false;  // the residual asked for was reached, or nothing overlaps any more
};

// Moves x and y, from report to report. What it is given stays where it is, and x and y are left alone meanwhile.
class Relaxation {
 public:
  // held[i] != 0: disc i stays (empty: none does). Ends at rest or after `most` iterations. `workers` share it if it is large; none: the
  // calling thread alone.
  Relaxation(const RelaxationBox& box, const Array<double>& radius, Array<double>& x, Array<double>& y,
             const std::vector<char>& held, double residual, std::int64_t most, Workers* workers = nullptr);
  Relaxation(Relaxation&&) noexcept;
  ~Relaxation();

  // To where there is something to report, after the same number of iterations on any number of workers. False: it has ended.
  bool go_on();
  [[nodiscard]] double done() const;  // 0 to 1
  [[nodiscard]] const RelaxationReport& report() const;

 private:
  class Course;
  std::unique_ptr<Course> course_;
};

// The same to its end, or until progress(fraction) returns true, which is asked on the calling thread now and then.
RelaxationReport relax_overlaps(const RelaxationBox& box, const Array<double>& radius, Array<double>& x,
                                Array<double>& y, const std::vector<char>& held, double residual,
                                std::int64_t most, const std::function<bool(double)>& progress = {},
                                Workers* workers = nullptr);

}  // namespace hfrac
