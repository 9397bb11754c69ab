// SPDX-License-Identifier: BSD-3-Clause
// Loads a specimen step by step until it fails, and keeps the curve.
//
// A step is as long as the rock allows: rock between two breaks is nearly linear, so from the largest stress over strength
// of a bond the next break is foreseen. A step that takes a bond more than `overshoot` beyond its strength is taken again
// shorter, down to `least` of the load; then bonds break in order, the farthest beyond its strength first, at this load until
// none is left to break. Both the equilibrium before the break and the one after it are points of the curve.
//
// Rock whose bonds soften gives way gradually: from where the first begins to, steps are equal (`soft_step` of the load there), and where no
// equilibrium is found, or one that takes more energy than the loads brought, they are halved, to a sixteenth; then damped motion goes on from the last one, to the next there is or to failure.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "lab/specimen.hpp"

namespace hfrac {

struct Loading {
  std::function<void(double)> apply;  // puts a load on, from 0 upwards
  std::function<double()> stress;     // Pa, positive, what the test's strength is the largest value of
  double first = 1e-5;                // first load tried; small against the load at failure
  double most = 0.0;                  // the test ends at this load; 0: at failure
  double end_share = 0.5;             // ... or when stress has fallen to this share of its peak
  std::int64_t runaway = 1000000000;  // ... or when more than so many bonds break at one load
  bool constant = false;              // load that does not give way: no equilibrium after a break is failure
  double overshoot = 0.01, least = 1e-3;
  double soft_step = 0.01;
};

struct CurvePoint {
  double load = 0.0, stress = 0.0;      // as of Loading
  double axial = 0.0, lateral = 0.0;    // strains of the gauge, extension positive
  double excess = 0.0;                  // largest stress over strength, before breakage if any
  std::int64_t tensile = 0, shear = 0;  // cracks so far
};

enum class TestEnd : std::int32_t { failed = 0, load_reached = 1, no_equilibrium = 2, stopped = 3 };

struct LoadingResult {
  std::vector<CurvePoint> curve;
  double peak = 0.0, strain_at_peak = 0.0;  // Pa, 1
  double first_crack = 0.0;                 // Pa, stress at the first break
  double force_ratio = 0.0;                 // largest of all points kept
  double worst_overshoot = 0.0;             // likewise less 1, of the breaks up to the peak
  TestEnd end = TestEnd::failed;
};

// interrupt() true ends the test with what there is (TestEnd::stopped).
LoadingResult load_to_failure(Specimen& specimen, const Loading& loading,
                              const std::function<bool()>& interrupt = {});

}  // namespace hfrac
