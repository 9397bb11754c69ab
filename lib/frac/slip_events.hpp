// SPDX-License-Identifier: BSD-3-Clause
// Slips of smooth joints as seismic events.
//
// What slipped in the same increment of a step (or within the window asked for) on contacts near each other is one event
// (frac/linking.hpp), over several joints where they meet. So a front of slip that moves on from increment to increment is several events, or one
// with a window longer than the increments.
//
// The moment of slip s on a length l of a joint with normal n, t being n turned by 90 degrees, in h metres of rock of shear modulus G
// (Aki and Richards 2002, section 3.2, a double couple):
//   m_ij = G h l s (t_i n_j + n_i t_j),   so that of one joint alone  M_0 = G h sum of l s
// The opening that comes with slip (dilation) is not in it.
//
// All slip counts, slow slip too, which shakes nothing: equilibria know no speeds. Slower than `slip_rate` over the increment it is left out.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frac/linking.hpp"
#include "frac/seismic_event.hpp"

namespace hfrac {

// A slip as the catalogue needs it.
struct CatalogueSlip {
  Vec2 position, normal;              // m; from first to second disc
  double length = 0.0;                // m, of the joint
  double slip = 0.0;                  // m
  double disc_distance = 0.0;         // m
  double shear_modulus = 0.0;         // Pa
  double time = 0.0, duration = 0.0;  // s
  std::int64_t id = 0, bond = 0;
};

struct SlipRule {
  LinkRule link{};
  double thickness = 1.0;  // m, of the slice of rock that the plane stands for
  double slip_rate = 0.0;  // m/s, over an increment: slower is no event
};

// In order of the first slip.
std::vector<SeismicEvent> find_slip_events(std::span<const CatalogueSlip> slips, const SlipRule& rule);

}  // namespace hfrac
