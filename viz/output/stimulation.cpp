// SPDX-License-Identifier: BSD-3-Clause
#include "output/stimulation.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac::output {
namespace {

constexpr int32_t open_state = 3;  // of the field joint.state

}  // namespace

JointMeasure measure_joints(hfrac_sim* sim) {
  const auto begin = doubles(sim, HFRAC_JOINT_BEGIN), end = doubles(sim, HFRAC_JOINT_END),
             slip = doubles(sim, HFRAC_JOINT_SLIP);
  const auto state = integers(sim, HFRAC_JOINT_CONTACT_STATE);
  JointMeasure result;
  for (size_t k = 0; k < slip.size(); ++k) {
    const double piece = std::hypot(end[2 * k] - begin[2 * k], end[2 * k + 1] - begin[2 * k + 1]);
    result.length += piece;
    if (std::abs(slip[k]) > kSlipped) result.slipped_length += piece;
    if (state[k] == open_state) result.open_length += piece;
    result.largest_slip = std::max(result.largest_slip, std::abs(slip[k]));
  }
  return result;
}

double injectivity(const hfrac_well_state& well, const Definition& definition) {
  const bool total = definition.stress_convention == 0;  // otherwise pressures are above the formation's
  const double above = well.pressure - (total ? definition.fluid_formation_pressure : 0.0);
  return above > 0.0 ? well.rate / above : std::nan("");
}

}  // namespace hfrac::output
