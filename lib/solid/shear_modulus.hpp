// SPDX-License-Identifier: BSD-3-Clause
// The rock's shear modulus, estimated from its bonds.
//
// If every disc moved as the mean strain says, a bond of length l with the stiffnesses k_n and k_s would store 1/2 l^2 (k_n (n.e.n)^2 +
// k_s (t.e.n)^2), and bonds that look all ways alike make of a pure shear
//   G = (k_n + k_s) / (8 A) * sum of l^2        A: the area of the model
// (uniform strain; Agnolin and Kruyt 2008, Comput. Math. Appl. 55, 245-256). Discs of a packing give way more than that, so it
// is an upper bound, by some tens of per cent.
#pragma once

#include "model/assembly.hpp"
#include "options/options.hpp"

namespace hfrac {

// Pa, per metre of thickness, in plane strain. Rock without joints: those take bonds away, not stiffness of the rock beside them.
double mean_field_shear_modulus(const Assembly& assembly, const Options& options);

}  // namespace hfrac
