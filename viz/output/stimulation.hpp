// SPDX-License-Identifier: BSD-3-Clause
// What the smooth joints of a model did, in a few numbers, and how easily its wells take fluid. They stand in the history and the
// summary of models with smooth joints only: other runs have the columns they always had.
#pragma once

#include "run/snapshot_grids.hpp"

namespace hfrac::output {
using namespace hfrac::run;

/** [m] Beyond it, since the initial equilibration, a piece of a joint counts as slipped: a hundred micrometres, which lift faces by their dilation as much as a
 * tight joint is open. */
inline constexpr double kSlipped = 1e-4;

struct JointMeasure {
  double length = 0.0;          ///< [m] of all contacts' pieces
  double slipped_length = 0.0;  ///< [m] of those that slipped by more than kSlipped
  double open_length = 0.0;     ///< [m] of those whose faces bear nothing
  double largest_slip = 0.0;    ///< [m] without its sign
};
JointMeasure measure_joints(hfrac_sim* sim);

/** [m2/(Pa s)] Rate of a well over its pressure above the formation's; NaN where it is not above it. */
double injectivity(const hfrac_well_state& well, const Definition& definition);

/** The columns of history.csv and the part of summary.json. */
template <class Visit>
void joint_columns(const JointMeasure& joints, const Visit& visit) {
  visit("joint_slipped_length_m", joints.slipped_length);
  visit("joint_open_length_m", joints.open_length);
  visit("joint_largest_slip_m", joints.largest_slip);
}

}  // namespace hfrac::output
