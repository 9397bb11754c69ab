// SPDX-License-Identifier: BSD-3-Clause
// Growth at a fracture's tip by its stress intensity, found from how far the faces behind it stand open.
//
// A crack of half length l under an even pressure opens by  w = (8 K / E') sqrt(s (1 - s / (2 l)) / (2 pi)),  s the distance to the tip
// (Sneddon 1946; Irwin 1957 for s << l; plane strain). The openings of the last few facets give K by least squares, l is half the way
// to the fracture's other end. An opening is a sum over the model: it feels neither what one bond happens to bear
// nor the confining stress, which a stress criterion on a disc does: there K_Ic would grow by sigma sqrt(R). A pore with exactly
// one broken bond is a tip; where K reaches K_Ic the bond ahead breaks that bears the largest mean tension on its facet.
#pragma once

#include <vector>

#include "frac/facets.hpp"

namespace hfrac {

struct Tip {
  std::int32_t domain = -1;
  double intensity = 0.0;   // Pa m^0.5
  std::int64_t ahead = -1;  // bond that breaks next, -1: none
};

std::vector<Tip> find_tips(const Facets& facets, const Assembly& assembly, const Network& network,
                           const Options& options);

}  // namespace hfrac
