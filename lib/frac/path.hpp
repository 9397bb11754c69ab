// SPDX-License-Identifier: BSD-3-Clause
// The way on from a pore that keeps to a line best: which bond a fracture breaks next, and which a perforation cuts.
//
// A way through pores turns by the disc, and a tip that turned away from the plane of least stress is shut by the larger stress across it
// (sigma_n = sigma_hmin + (sigma_Hmax - sigma_hmin) sin^2 of the turn). So ways of a few bonds are compared: how far each leads along the
// line, less how far its pores are off it.
#pragma once

#include <cstdint>
#include <vector>

#include "frac/facets.hpp"

namespace hfrac {

struct Line {
  Vec2 through;  // m
  Vec2 along;    // unit
};

// The first bond of that way, -1: none. `passed`: pores that it must not come to; `cut`: bonds as good as broken. Of
// each disc's bonds a way leaves `kept`.
std::int64_t straightest(const Facets& facets, const Assembly& assembly, const Network& network,
                         std::int32_t from, const Line& line, const std::vector<std::int32_t>& passed,
                         const std::vector<std::int64_t>& cut, std::int64_t kept = 1);

// Bonds that a perforation of this length [m] cuts into the rock beside a well, along `way` from its centre. On a single bond a disc at
// the hole's wall is a cantilever into the hole, which the stress that the slot releases pries off, and the wall beside it with it,
// before anything is injected. So a way that leaves each disc two bonds is taken, unless it has a steeper bond: across such a one the
// larger stress shuts the slot.
std::vector<std::int64_t> perforation(const Facets& facets, const Assembly& assembly, const Network& network,
                                      const WellPlace& well, Vec2 way, double length);

}  // namespace hfrac
