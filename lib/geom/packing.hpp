// SPDX-License-Identifier: BSD-3-Clause
// A dense, relaxed packing of discs in a rectangle.
//
// Radii are drawn evenly between R_min and R_max and scaled so that the discs fill (1 - porosity) of the box. Discs
// start on a jittered lattice, overlapping at random, and the energy of their overlaps (contacts without friction, the
// box's sides as flat walls) is minimised with FIRE (Bitzek et al. 2006) until the forces balance. What overlap is left
// carries no stress later: bonding takes the gaps it finds as reference.
#pragma once

#include <cstdint>
#include <functional>

#include "core/array.hpp"

namespace hfrac {

struct PackingOptions {
  double width = 100.0;        // m
  double height = 100.0;       // m
  std::int64_t count = 10000;  // discs
  double radius_ratio = 2.7;   // R_max / R_min
  double porosity = 0.15;      // void fraction
  double residual = 1e-4;      // mean unbalanced over mean contact force to reach
  std::uint64_t seed = 1;
};

struct Packing {
  Array<double> x, y, radius;  // m; numbered along a Hilbert curve
  double residual = 0.0;       // mean unbalanced over mean contact force
  double mean_radius = 0.0;    // m
  double mean_overlap = 0.0;   // mean overlap of contacts over mean radius
};

// progress(fraction) may return true to stop; the packing is then not relaxed. Throws Error(model) if it does not relax.
Packing pack_discs(const PackingOptions& options, const std::function<bool(double)>& progress = {});

// The permutation that numbers points along a Hilbert curve: order[new] = old.
std::vector<std::int32_t> hilbert_order(const Array<double>& x, const Array<double>& y);

}  // namespace hfrac
