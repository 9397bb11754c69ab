// SPDX-License-Identifier: BSD-3-Clause
// The four grids of a snapshot. Each function reads what it needs from the simulation and gives the text of a
// VTU file.
#pragma once

#include <string>

#include "output/array_coding.hpp"
#include "output/engine_call.hpp"

namespace hfrac::output {

/** What every grid of a snapshot needs; read once. */
struct SnapshotFrame {
  explicit SnapshotFrame(hfrac_sim* simulation);

  hfrac_sim* sim;
  hfrac_sim_state state;
  std::vector<hfrac_well_state> wells;
  std::vector<hfrac_fracture> fractures;
  std::vector<hfrac_crack> cracks;
  std::vector<double> positions;  ///< disc centres now, x0 y0 x1 y1 ...
  Coding coding;                  ///< of the arrays in the files
  bool warm;                      ///< the run has a temperature
};

/** Discs as points with radius, displacement, rotation, stress and number of intact bonds. */
std::string disc_vtu(const SnapshotFrame& frame);
/** Bonds as lines from centre to centre, with forces and the pipe that crosses each of them. */
std::string bond_vtu(const SnapshotFrame& frame);
/** Cracks as lines across the contact they opened. */
std::string crack_vtu(const SnapshotFrame& frame);
/** Fluid domains as polygons of disc centres with their pressure. */
std::string flow_vtu(const SnapshotFrame& frame);

}  // namespace hfrac::output
