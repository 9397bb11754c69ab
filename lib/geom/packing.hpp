// SPDX-License-Identifier: BSD-3-Clause
// A dense, relaxed packing of discs in a rectangle, made in one of four ways:
//
//   relaxed  Radii are spread evenly between R_min and R_max and scaled so that the discs fill (1 - porosity) of the box.
//            Discs start on a jittered lattice, overlapping at random, and are relaxed (relaxation.hpp).
//   growth   The same radii at random places, small at first; discs grow in stages and are relaxed at each: a packing
//            that knows of no lattice.
//   tiled    A periodic brick is packed once and laid side by side; cost grows with the number of discs and no faster
//            (tiled_packing.cpp).
//   square   Equal discs in rows and columns that touch. As rock it is elastic with E' = k_n and nu = 0 per metre of thickness
//            (contacts after a break only), isotropic if k_s = k_n; cracks along rows are slits of the cubic law.
//
// A relaxed packing may be graded, fine where a fracture goes and coarser outwards (graded_packing.cpp).
//
// What overlap is left carries no stress later: bonding takes the gaps it finds as reference.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/array.hpp"
#include "core/random.hpp"
#include "core/ranks.hpp"
#include "options/choices.hpp"
#include "options/grading.hpp"

namespace hfrac {

struct Options;
class Workers;

struct PackingOptions {
  double width = 100.0;        // m
  double height = 100.0;       // m
  std::int64_t count = 10000;  // discs; tiled: up to half a disc per brick more or less
  double radius_ratio = 2.7;   // R_max / R_min
  double porosity = 0.15;      // void fraction
  double residual = 1e-4;      // mean unbalanced over mean contact force to reach
  std::uint64_t seed = 1;
  PackingMethod method = PackingMethod::relaxed;
  std::int64_t brick = 5000;  // discs in a brick (tiled)
  Grading sizes;              // by place, if graded
};

// What the options of a model say of its packing, but for the places of fine discs.
PackingOptions packing_options(const Options& options);

struct Packing {
  Array<double> x, y, radius;  // m; numbered along a Hilbert curve
  double residual = 0.0;       // mean unbalanced over mean contact force
  double mean_radius = 0.0;    // m; graded: of the fine discs
  double mean_overlap = 0.0;   // mean overlap of contacts over mean radius of all
  Grading sizes;               // of a graded packing, as it came out
};

// progress(fraction) may return true to stop; the packing is then not relaxed. Throws Error(model) if it does not relax.
// `workers` share the work (none: the calling thread alone), and so do `ranks` where bricks are laid; the packing is the same.
Packing pack_discs(const PackingOptions& options, const std::function<bool(double)>& progress = {},
                   Workers* workers = nullptr, const Ranks& ranks = {});

// The permutation that numbers points along a Hilbert curve: order[new] = old.
std::vector<std::int32_t> hilbert_order(const Array<double>& x, const Array<double>& y);

// Parts of the above, for tiled_packing.cpp and graded_packing.cpp.
// `count` radii evenly over the range, shuffled, filling (1 - porosity) of `area`.
Array<double> spread_radii(const PackingOptions& options, std::int64_t count, double area, Random& random);
// Jittered lattice sites for as many discs as the packing has radii.
void place_on_lattice(double width, double height, Random& random, Packing& packing);
// To rest, or Error(model); numbered along the curve.
void relax_packing(const PackingOptions& options, Packing& packing,
                   const std::function<bool(double)>& progress, Workers* workers);
void renumber(Packing& packing);
Packing pack_tiled(const PackingOptions& options, const std::function<bool(double)>& progress,
                   Workers* workers, const Ranks& ranks);
Packing pack_graded(const PackingOptions& options, const std::function<bool(double)>& progress,
                    Workers* workers);

}  // namespace hfrac
