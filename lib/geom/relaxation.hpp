// SPDX-License-Identifier: BSD-3-Clause
// Lets overlapping discs push each other apart until their forces balance: the energy of overlaps (stiffness 1, no
// friction) is minimised with FIRE (Bitzek, Koskinen, Gähler, Moseler and Gumbsch 2006). The sides of the box are flat
// walls, or its opposite sides are one and the same (periodic). Every sum is made in one order: the same bits on any number of workers.
#pragma once

#include <cstdint>
#include <functional>
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

// Moves x and y. held[i] != 0: disc i stays (empty: none does). Ends at rest, after `most` iterations, or when
// progress(fraction) returns true, which is asked on the calling thread now and then. `workers` share it if it is large; none: the
// calling thread alone.
RelaxationReport relax_overlaps(const RelaxationBox& box, const Array<double>& radius, Array<double>& x,
                                Array<double>& y, const std::vector<char>& held, double residual,
                                std::int64_t most, const std::function<bool(double)>& progress = {},
                                Workers* workers = nullptr);

}  // namespace hfrac
