// SPDX-License-Identifier: BSD-3-Clause
// A fracture as an ordered line: what is read beside the profiles of analytic solutions.
//
// From the end of one wing to that of the other, on the longest ways from the well, or from end to end of a fracture that no well
// feeds. Branches beside these ways are left out.
#pragma once

#include <cstdint>
#include <vector>

#include "model/assembly.hpp"
#include "model/crack_log.hpp"
#include "model/network.hpp"
#include "model/well.hpp"

namespace hfrac {

struct FracturePoint {
  std::int64_t bond;
  Vec2 at;  // m, middle of the crack
  double
      distance;  // m along the line, 0 at the well's centre (or the line's middle), below 0 on the first wing
  double length;              // m of the line that this crack stands for
  double aperture;            // m, mechanical
  double hydraulic_aperture;  // m
  double pressure;            // Pa, mean of its two pores
  double saturation;          // share of its two pores' volume that fluid fills
  std::int32_t wing;          // 0, 1; -1 without a well
  bool tip;                   // the line ends here
};

// Of the fracture that the log numbers so (find_fractures).
std::vector<FracturePoint> fracture_line(const Assembly& assembly, const Network& network,
                                         const Options& options, const std::vector<WellPlace>& wells,
                                         const CrackLog& log, std::int32_t fracture);

}  // namespace hfrac
