// SPDX-License-Identifier: BSD-3-Clause
// A joint of the C interface by its first eight members; those of smooth joints at 0, their default.
#pragma once

#include "hfrac/def.h"

constexpr hfrac_joint_def joint_def(double x1, double y1, double x2, double y2, double tensile_factor,
                                    double shear_factor, double friction, int64_t state) {
  hfrac_joint_def joint{};
  joint.x1 = x1;
  joint.y1 = y1;
  joint.x2 = x2;
  joint.y2 = y2;
  joint.tensile_factor = tensile_factor;
  joint.shear_factor = shear_factor;
  joint.friction = friction;
  joint.state = state;
  return joint;
}
