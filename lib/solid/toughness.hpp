// SPDX-License-Identifier: BSD-3-Clause
// Strength of bonds from the fracture toughness of the rock.
//
// A crack in a bonded assembly ends in a disc, not in a point: the bond ahead of it bears what the singular stress has within
// about a disc radius. So the assembly's toughness is
//     K_Ic = c sigma_c sqrt(R)                                             (Potyondy and Cundall 2004, section 3.4)
// with c of the order of one, a matter of packing, contact law and ratios of stiffness, and rock of a given toughness needs
// weaker bonds where discs are larger. c is measured by the laboratory: `hfrac lab centre-crack`, docs/verification/V8.md.
//
// R is the mean radius around the bond: of its two discs, their neighbours, and the neighbours' neighbours, each disc by how
// many ways lead to it. One bond's own two discs would make strength scatter from bond to bond, which weakens a rock by itself.
#pragma once

#include "model/assembly.hpp"
#include "options/options.hpp"

namespace hfrac {

// c as measured for the default rock of either contact mode; bond.toughness_coefficient replaces it.
double toughness_coefficient(const Options& options);

// Sets the assembly's strengths: sigma_c = K_Ic / (c sqrt(R)) by bond, tau_c in proportion.
void apply_fracture_toughness(Assembly& assembly, const Options& options);

}  // namespace hfrac
