// SPDX-License-Identifier: BSD-3-Clause
// Growth at a fracture's tip by its stress intensity, found from how far the faces behind it stand open.
//
// A crack of half length l under an even pressure opens by  w = (8 K / E') sqrt(s (1 - s / (2 l)) / (2 pi)),  s the distance to the tip
// (Sneddon 1946; Irwin 1957 for s << l; plane strain). The openings of the last few facets give K by least squares, l is half the way
// to the fracture's other end. In a fluid that has to be driven to a moving tip the opening is larger than that (Dontsov and Peirce 2015,
// without leak-off; mu' = 12 eta, K' = 4 sqrt(2 / pi) K_Ic, speed V):
//   w^3 = (K' / E')^3 s^(3/2) + beta^3 (mu' V / E') s^2,   beta = 2^(1/3) 3^(5/6)
// and this is what the tip goes on at: with the length of the last facet over the time since it broke for V, it goes as fast as the
// fluid opens it, however coarse the discs are. An opening is a sum over the model: it feels neither what one bond happens to bear
// nor the confining stress, which a stress criterion on a disc does: there K_Ic would grow by sigma sqrt(R). A pore with exactly
// one broken bond is a tip; where K reaches K_Ic the bond ahead breaks that bears the largest mean tension on its facet. A pore that a
// broken joint passes through is none, since the joint opens and slips there and blunts what ends in it: whether the rock beyond breaks,
// and where along the joint, its strength says (as criteria of crossing have it, Renshaw and Pollard 1995).
#pragma once

#include <vector>

#include "frac/facets.hpp"

namespace hfrac {

struct Tip {
  std::int32_t domain = -1;
  double intensity = 0.0;   // Pa m^0.5
  double excess = 0.0;      // opening over that at which the tip goes on
  std::int64_t ahead = -1;  // bond that breaks next, -1: none
};

std::vector<Tip> find_tips(const Facets& facets, const Assembly& assembly, const Network& network,
                           const Options& options, double time);

}  // namespace hfrac
