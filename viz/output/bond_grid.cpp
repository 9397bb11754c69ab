// SPDX-License-Identifier: BSD-3-Clause
// bonds_*.vtu: one line per bonded contact, whole or broken. The pipe that crosses a bond has the bond's
// index.
#include "output/snapshot_grids.hpp"
#include "output/vtu_grid.hpp"

namespace hfrac::output {

std::string bond_vtu(const SnapshotFrame& frame) {
  const auto discs = integers(frame.sim, HFRAC_BOND_DISCS);
  const size_t count = discs.size() / 2;

  VtuGrid grid;
  grid.positions = frame.positions;
  grid.cell_type = CellType::line;
  grid.offsets = even_offsets(count, 2);
  grid.connectivity = discs;
  auto& data = grid.cell_data;
  data.push_back(whole("state", integers(frame.sim, HFRAC_BOND_STATE)));
  data.push_back(floats("normal_force_N", "N", doubles(frame.sim, HFRAC_BOND_NORMAL_FORCE)));
  data.push_back(floats("shear_force_N", "N", doubles(frame.sim, HFRAC_BOND_SHEAR_FORCE)));
  data.push_back(floats("moment_Nm", "N m", doubles(frame.sim, HFRAC_BOND_MOMENT)));
  data.push_back(floats("gap_m", "m", doubles(frame.sim, HFRAC_BOND_GAP)));
  data.push_back(floats("aperture_m", "m", doubles(frame.sim, HFRAC_PIPE_APERTURE)));
  data.push_back(floats("flow_m2_per_s", "m2/s", doubles(frame.sim, HFRAC_PIPE_FLOW)));
  data.push_back(numbering("bond_id", count));
  return encode(grid, frame.state, frame.wells, frame.coding);
}

}  // namespace hfrac::output
