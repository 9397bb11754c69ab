// SPDX-License-Identifier: BSD-3-Clause
// The grids of a snapshot, made from a simulation: what discs_*.vtu, bonds_*.vtu, cracks_*.vtu, flow_*.vtu and fractures_*.vtu hold,
// and joints_*.vtu of a model with smooth joints.
#pragma once

#include <vector>

#include "run/engine_call.hpp"
#include "run/vtu_writer.hpp"

namespace hfrac::run {

/** What every grid of a snapshot needs; read once. */
struct SnapshotFrame {
  explicit SnapshotFrame(hfrac_sim* simulation);

  hfrac_sim* sim;
  hfrac_sim_state state;
  std::vector<hfrac_well_state> wells;
  std::vector<hfrac_fracture> fractures;
  std::vector<hfrac_crack> cracks;
  std::vector<double> positions;  ///< disc centres now, x0 y0 x1 y1 ...
  bool warm;                      ///< the run has a temperature
  bool two_fluids;                ///< the run has a second fluid
  bool jointed;                   ///< it has smooth joints
  Moment moment;
};

/** Discs as points; scale glyphs by radius_m to see the packing. This and the next but one may be had in parts. */
VtuGrid disc_grid(const SnapshotFrame& frame, Part part = {});
/** A line from centre to centre per bonded contact, whole or broken, with the pipe that crosses it. */
VtuGrid bond_grid(const SnapshotFrame& frame, Part part = {});
/** A line per broken bond, drawn where the rock parts: across the contact, not along the bond. */
VtuGrid crack_grid(const SnapshotFrame& frame);
/** Each fracture of two cracks or more as one line from tip to tip, with what the fluid does along it at its points. */
VtuGrid fracture_grid(const SnapshotFrame& frame);
/** A line per contact of a smooth joint: its piece of the joint as it lies now. Empty without smooth joints. */
VtuGrid joint_grid(const SnapshotFrame& frame);
/** Each fluid domain as the polygon of the disc centres around it; the outside has no polygon. */
VtuGrid flow_grid(const SnapshotFrame& frame, Part part = {});

}  // namespace hfrac::run
